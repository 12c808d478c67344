//! Examples that `--help` shows of each command in use. A test reads every line as the program would.

/// Examples of `serve`.
pub(crate) const SERVE: &str = "Examples:
  strainsite serve
  strainsite serve --addr 127.0.0.1:9000 --db tires.db
  strainsite serve --config strainsite.toml --token-file token.txt --addr 0.0.0.0:8080";

/// Examples of `run`.
pub(crate) const RUN: &str = "Examples:
  strainsite run foot-tire
  strainsite run studies/foot-tire.toml --dry-run
  strainsite run studies/foot-tire.toml --set geometry.wall_mm=2.5 --set accuracy.preset=coarse --set name=thin
  strainsite run studies/foot-tire.toml --set 'method={\"kind\":\"tensor\",\"nodes\":5}' --engine slurm
  strainsite run studies/foot-tire.toml --db tires.db --out answer --json result.json";

/// Examples of `solve`.
pub(crate) const SOLVE: &str = "Examples:
  strainsite solve scenes/foot-tire.toml
  strainsite solve scenes/foot-tire.toml --set pressure.internal_mpa=0.15 --set 'ground.depths_mm=[1,1,2,1,1]' --json -
  strainsite solve scenes/foot-tire.toml --set ground.load_n=13
  strainsite solve scenes/foot-tire.toml --at 0,45 --vtu tire.vtu
  strainsite solve scenes/foot-tire.toml --derivatives ground.load_n,pressure.internal_mpa --set ground.load_n=13
  strainsite solve scenes/foot-tire.toml --set carcass=null --solver calculix";

/// Examples of `gsa`.
pub(crate) const GSA: &str = "Examples:
  strainsite gsa plan inputs.toml -o points.csv
  strainsite gsa analyse inputs.toml values.csv --json indices.json
  strainsite gsa plan inputs.toml --values values.csv
  strainsite gsa run inputs.toml --model http://127.0.0.1:4242 --at-once 100";

/// Examples of `gsa plan`.
pub(crate) const GSA_PLAN: &str = "Examples:
  strainsite gsa plan inputs.toml -o points.csv
  strainsite gsa plan inputs.toml --values values.csv";

/// Examples of `gsa analyse`.
pub(crate) const GSA_ANALYSE: &str = "Examples:
  strainsite gsa analyse inputs.toml values.csv
  strainsite gsa analyse inputs.toml values.csv --json -";

/// Examples of `gsa run`.
pub(crate) const GSA_RUN: &str = "Examples:
  strainsite gsa run inputs.toml --model http://127.0.0.1:4242
  strainsite gsa run inputs.toml --model http://cluster:4242 --at-once 100 --db runs.db --json -
  strainsite gsa run inputs.toml --model http://127.0.0.1:4242 --name forward --config '{\"level\": 2}' --outputs drag,lift -o values.csv";

/// Examples of `force`.
pub const FORCE: &str = "Examples:
  strainsite force look monday.csv tuesday.csv
  strainsite force fit recipe.toml monday.csv tuesday.csv -o model.json
  strainsite force apply model.json friday.csv -o forces.csv
  strainsite force apply model.json - -o forces.csv";

/// Examples of `force look`.
pub(crate) const FORCE_LOOK: &str = "Examples:
  strainsite force look monday.csv tuesday.csv
  strainsite force look --recipe recipe.toml --json - monday.csv
  strainsite force look logger.csv --convert monday.csv";

/// Examples of `force fit`.
pub(crate) const FORCE_FIT: &str = "Examples:
  strainsite force fit recipe.toml monday.csv tuesday.csv -o model.json
  strainsite force fit recipe.toml monday.csv tuesday.csv --json -";

/// Examples of `force apply`.
pub(crate) const FORCE_APPLY: &str = "Examples:
  strainsite force apply model.json friday.csv -o forces.csv
  strainsite force apply model.json -";

/// Examples of `force record`.
pub(crate) const FORCE_RECORD: &str = "Examples:
  strainsite force record studies/forces.toml --layout 1 -o recordings
  strainsite force record forces --layout 2 --set rig.electronics.time_constant_s=0.1";

/// Examples of `trade`.
pub(crate) const TRADE: &str = "Examples:
  strainsite trade studies/foot-tire.toml --out trade
  strainsite trade studies/foot-tire.toml --json -";

/// Examples of `sweep`.
pub(crate) const SWEEP: &str = "Examples:
  strainsite sweep studies/foot-tire.toml --grid geometry.wall_mm=2.5,3,3.5 --grid carcass.angle_deg=50,55
  strainsite sweep studies/foot-tire.toml --grid geometry.wall_mm=2.5,3 --set accuracy.preset=coarse
  strainsite sweep studies/foot-tire.toml --grid 'layouts.spacings_deg=[60],[90]' --dry-run
  strainsite sweep studies/foot-tire.toml --grid geometry.wall_mm=2.5,3,3.5 --engine slurm --slurm-options=--partition=short
  strainsite sweep --resume 019aa2b3
  strainsite sweep --resume 019aa2b3 --grid geometry.wall_mm=4 --json sweep.json";

/// Examples of `umbridge`.
pub(crate) const UMBRIDGE: &str = "Examples:
  strainsite umbridge studies/foot-tire.toml
  strainsite umbridge foot-tire --set accuracy.preset=coarse --addr 127.0.0.1:4243";

/// Examples of `tasks make`.
pub(crate) const TASKS_MAKE: &str = "Examples:
  strainsite tasks make tensor.toml --dir points
  strainsite tasks make studies/foot-tire.toml --grid geometry.wall_mm=2.5,3,3.5 --dir walls
  strainsite tasks make --resume 019aa2b3 --dir again --minutes 30";

/// Examples of `tasks run`.
pub(crate) const TASKS_RUN: &str = "Examples:
  strainsite tasks run walls 1
  strainsite tasks run walls 2 --threads 8";

/// Examples of `tasks gather`.
pub(crate) const TASKS_GATHER: &str = "Examples:
  strainsite tasks gather walls
  strainsite tasks gather walls --db tires.db --json gathered.json";

/// Examples of `compare`.
pub(crate) const COMPARE: &str = "Examples:
  strainsite compare 019aa2b3 019aa2c7
  strainsite compare 019aa2b3 --baseline 019aa2d0 --json comparison.json
  strainsite compare 019aa2b3 --format parquet --table designs -o designs.parquet";

/// Examples of `presets`.
pub const PRESETS: &str = "Examples:
  strainsite presets
  strainsite presets --json -";

/// Examples of `list`.
pub const LIST: &str = "Examples:
  strainsite list
  strainsite list --sweeps
  strainsite list --search wall
  strainsite list --state done --limit 10 --json -";

/// Examples of `show`.
pub(crate) const SHOW: &str = "Examples:
  strainsite show 019aa2b3
  strainsite show 019aa2b3 --db tires.db --json -";

/// Examples of `export`.
pub(crate) const EXPORT: &str = "Examples:
  strainsite export 019aa2b3 --table locations -o locations.csv
  strainsite export 019aa2b3 --format parquet --table points -o points.parquet
  strainsite export 019aa2b3 --format vtu -o map.vtu";

/// Examples of `db`.
pub(crate) const DB: &str = "Examples:
  strainsite db check --db tires.db
  strainsite db backup copy.db
  strainsite db restore copy.db
  strainsite db merge colleague.db other.db
  strainsite db vacuum";

/// Examples of `validate`.
pub(crate) const VALIDATE: &str = "Examples:
  strainsite validate studies/foot-tire.toml";

/// Examples of `schema`.
pub(crate) const SCHEMA: &str = "Examples:
  strainsite schema study
  strainsite schema recipe";

/// Examples of `verify`.
pub(crate) const VERIFY: &str = "Examples:
  strainsite verify
  strainsite verify --extremes --json extremes.json";

/// Examples of `completions`.
pub(crate) const COMPLETIONS: &str = "Examples:
  strainsite completions bash
  strainsite completions zsh
  strainsite completions fish";

/// Examples of `man`.
pub(crate) const MAN: &str = "Examples:
  strainsite man
  strainsite man --out /usr/local/share/man/man1";
