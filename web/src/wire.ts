// Made from openapi.json by `npm run wire`; not edited by hand.

export type paths = Record<string, never>;
export type webhooks = Record<string, never>;
export interface components {
    schemas: {
        /** @description Two contacts that readings can hardly tell apart. */
        AlikeContacts: {
            /**
             * Format: double
             * @description Angle of the first, degrees; its depth is that of the load.
             */
            angle_deg: number;
            /**
             * Format: double
             * @description Angle of the second, degrees.
             */
            other_angle_deg: number;
            /**
             * Format: double
             * @description Depth of the second, mm.
             */
            other_depth_mm: number;
            /**
             * Format: double
             * @description Distance of their readings in standard deviations of the noise.
             */
            sigmas: number;
        };
        /** @description Error where contacts differ in angle, load and shear alone. */
        AlikeError: {
            /** @description Error of the estimates then. */
            error: components["schemas"]["TrialError"];
            /** @description Error of the rows with a contact alone. */
            in_contact: components["schemas"]["TrialError"];
        };
        /** @description Inputs of a model of your own, and the values of its outputs so far. */
        AnalysisDocument: {
            /** @description Inputs of the model. */
            inputs: components["schemas"]["ModelInputDocument"][];
            /** @description Method that computes the indices. */
            method?: components["schemas"]["AnalysisMethodDocument"];
            /** @description Values of the outputs so far. */
            values?: string | components["schemas"]["ListedValuesDocument"];
        };
        /** @description Answer of a study: where the films go, how sure that is, and what could overturn it. */
        Answer: {
            /** @description The answer: the best layout and what it knows; where no layouts are asked for the best place, or the input that matters more than the depth below it. */
            sentence: string;
            /** @description The answer in few characters, as lists of studies show it: `12 y films, 10.7 degrees`; null in results of earlier versions. */
            brief?: string | null;
            /** @description The weaker of the verdicts on layout and place, where several places are ranked; without layouts that on what the sentence tells. */
            verdict: components["schemas"]["Certainty"];
            /** @description Reason why it isn't surer, or why it is certain, with the figures that decide; whole sentences. */
            reason: string;
            place?: components["schemas"]["PlaceAnswer"] | null;
            layout?: components["schemas"]["LayoutAnswer"] | null;
            trade?: components["schemas"]["TradeAnswer"] | null;
            /** @description Films of the answer's layout, one by one, as they are glued. */
            films?: components["schemas"]["SheetFilm"][];
            rests_on?: components["schemas"]["RestsOn"] | null;
            inputs?: components["schemas"]["InputsAnswer"] | null;
            signals?: components["schemas"]["SignalsAnswer"] | null;
            left_out?: components["schemas"]["LeftOut"] | null;
            surer?: components["schemas"]["Surer"] | null;
        };
        /** @description Error with films askew. */
        AskewError: {
            /**
             * Format: double
             * @description Standard deviation of the films' places around the wheel, degrees.
             */
            std_deg: number;
            /** @description Error of the estimates then. */
            error: components["schemas"]["TrialError"];
        };
        /** @description An assumption, changed. */
        AssumptionChange: {
            /** @description Name of the assumption: `noise`, `drift`, `gain`, `place`, `pressure`, `camber` or `friction`. */
            of: string;
            /** @description Change in words, as in `a pressure 10 % lower`. */
            words: string;
            /**
             * Format: double
             * @description The angle's error then, degrees.
             */
            angle_error_deg: number;
            /**
             * Format: double
             * @description The force's error then, N.
             */
            force_error_n: number;
            /**
             * Format: double
             * @description Larger of both errors' ratios to those as assumed; of a smaller error one over that.
             */
            times: number;
            /** @description Rank of a layout of no more films that does better then, by more than chance; null where this one stays. */
            better_rank?: number | null;
            /** @description Whether it keeps to the limits of the question then; null where none is asked, or none was kept as assumed. */
            meets?: boolean | null;
        };
        /** @description Figures of the layout that answers, with what they rest on changed, one at a time. */
        AssumptionFindings: {
            /** @description Rank of that layout. */
            rank: number;
            /**
             * Format: double
             * @description 95 of 100 contact angles are estimated better than this at the worst load, degrees, as assumed.
             */
            angle_error_deg: number;
            /**
             * Format: double
             * @description Error of the vertical force at the load where that is largest, root mean square, N, as assumed.
             */
            force_error_n: number;
            /** @description Changed assumptions, the one that changes the figures most first. */
            changes: components["schemas"]["AssumptionChange"][];
            /** @description Assumptions that weren't changed, in words: those that the document names no value of, and those whose scene has no answer. */
            unchanged: string[];
        };
        /** @description Sweep whose designs other machines solve, or did. */
        AwaySweep: components["schemas"]["TaskReport"] & {
            /** @description Identifier of the sweep. */
            sweep: string;
            /** @description Time at which nothing of it went on any more; null while something does. What was left then has its turns at home. */
            ended?: string | null;
        };
        /** @description Errors of left-out runs by where they begin. */
        BeginningsReport: {
            /** @description Runs that begin under a load, which is taken for nothing where the first reading is taken off. */
            loaded: components["schemas"]["LoadedReport"][];
            /** @description Runs that are zeroed after lifting. */
            rested: components["schemas"]["RestedReport"][];
            /**
             * Format: double
             * @description Least rest after which the error is at most 1.2 times that of the same rows as recorded, s; null where no recorded rest is long enough.
             */
            rest_s?: number | null;
            /** @description Sentences that follow from it: when to zero, and what a begin under load does. */
            advice: string;
        };
        /** @description A kind of film: where in the section, along which direction, how large. */
        CandidateFilm: {
            /**
             * Format: double
             * @description Section angle from the crown, degrees.
             */
            section_deg: number;
            /** @description Direction of its length. */
            direction: string;
            /**
             * Format: double
             * @description Length of the film, mm; null of a point.
             */
            length_mm?: number | null;
            /**
             * Format: double
             * @description Width of the film, mm; null of a point.
             */
            width_mm?: number | null;
            /**
             * Format: double
             * @description Largest signal around the wheel, over all loads.
             */
            signal: number;
            /**
             * Format: double
             * @description Root of the mean information on the contact angle over the turn and the loads, 1/degree, at the noise of the layouts.
             */
            angle_information: number;
            /**
             * Format: double
             * @description Root of the mean information on the depth, 1/mm.
             */
            depth_information: number;
            /**
             * Format: double
             * @description Error of the information on the angle by the coarser mesh.
             */
            angle_information_error?: number | null;
        };
        /** @description Kinds of film for layouts, by several criteria. */
        Candidates: {
            /** @description Every section angle and direction. */
            candidates: components["schemas"]["CandidateFilm"][];
        };
        /** @description Least and greatest values over the whole textile layer. */
        CarcassState: {
            /** @description Stretch of the fibres. */
            fibre_stretch: components["schemas"]["Extremes"];
            /** @description Tension along the fibres: force per reference length across a family, N/mm; negative in compression. */
            tension_n_per_mm: components["schemas"]["Extremes"];
        };
        /**
         * @description Certainty of a first rank, by what the order goes by; surest first. Mirror images tie by symmetry: that isn't uncertainty.
         * @enum {string}
         */
        Certainty: "certain" | "likely" | "tied" | "unknown";
        /** @description A modelling choice with its reason. */
        Choice: {
            /** @description The part. */
            what: string;
            /** @description The reason. */
            why: string;
            /**
             * Format: double
             * @description Effect of leaving it out: the largest change of a strain at P1, P2, ... at the means when it is modelled, over the largest strain of that
             *     direction there.
             */
            effect?: number | null;
        };
        /**
         * @description Claim about films' voltages.
         * @enum {string}
         */
        Claim: "voltage rises with load" | "voltage falls with pressure" | "linear over the contact angle";
        /** @description Whether a claim holds of one film. */
        ClaimRow: {
            /** @description Name of the tire. */
            tire: string;
            /** @description Model of the film. */
            film: components["schemas"]["FilmModel"];
            /** @description Position of the film in the section. */
            position: string;
            /** @description Direction of its length. */
            direction: string;
            /** @description Claim about the curve. */
            claim: components["schemas"]["Claim"];
            /** @description Whether it holds. */
            holds: components["schemas"]["Holds"];
            /** @description Course of the curve, in words. */
            detail: string;
        };
        /** @description The way from a draft to the accuracy asked for. */
        Climb: {
            /**
             * Format: double
             * @description Largest error of an index that was asked for.
             */
            tolerance?: number | null;
            /**
             * Format: double
             * @description Wall-clock time that was allowed, s.
             */
            budget_s?: number | null;
            /** @description Whether the claimed error is within the tolerance, or the budget gave an answer. */
            met: boolean;
            /** @description Rungs that were tried, in order; the answer is the last one's. */
            rungs: components["schemas"]["ClimbRung"][];
        };
        /** @description A step of the way. */
        ClimbRung: {
            /** @description Label in a few words. */
            label: string;
            /** @description Mesh and method. */
            fidelity: components["schemas"]["FidelityReport"];
            /** @description Solves, those on the coarser mesh included. */
            solves: number;
            /**
             * Format: double
             * @description Largest claimed error of an index at P1, P2, ..., absolute.
             */
            error_claimed?: number | null;
            /**
             * Format: double
             * @description The mesh's part of it.
             */
            error_of_mesh?: number | null;
        };
        /** @description Indices of the same points on a coarser mesh: the witness of the mesh's error, and of how much of it two studies share. */
        CoarserIndices: {
            /** @description First-order index of each input. */
            first_order: number[];
            /**
             * Format: double
             * @description Error of the finer mesh over its difference from the coarser one.
             */
            factor: number;
        };
        /** @description Column that was looked at. Figures of a force are in newtons, those of the time in seconds. */
        ColumnLook: {
            /** @description Name of the column in the file. */
            column: string;
            /** @description Part that the column is taken for. */
            taken: components["schemas"]["Taken"];
            /** @description Name that estimates give the force; null of other columns. */
            force?: string | null;
            /**
             * Format: double
             * @description Newtons of one of a force's unit; null of other columns.
             */
            newtons?: number | null;
            /** @description Unit of a time in words; null of other columns. */
            time_unit?: string | null;
            /** @description Rows with a number. */
            measured: number;
            /** @description Empty cells, and words for them. */
            empty: number;
            /** @description Cells with text, which are read in columns that are taken for nothing or tell cycles apart. */
            texts: number;
            /**
             * Format: double
             * @description Least number; null of none.
             */
            least?: number | null;
            /**
             * Format: double
             * @description Greatest number; null of none.
             */
            greatest?: number | null;
            /**
             * Format: double
             * @description Deviation of the noise: median size of the differences between neighbours, over sqrt(2) 0.6745.
             */
            noise?: number | null;
            /**
             * Format: double
             * @description Median where no force acts: where each is below a twentieth of its largest.
             */
            unloaded?: number | null;
            /**
             * Format: double
             * @description Median of the last third of the rows without a force less that of the first third; null of fewer than 30 such rows.
             */
            drift?: number | null;
            /** @description Samples that stand alone: away from both neighbours by more than 20 robust deviations of the differences between neighbours. */
            lone: components["schemas"]["LoneSamples"];
            /** @description Sentences on what makes the column suspect. */
            suspicions: string[];
        };
        /** @description A column over time. */
        ColumnSeries: {
            /** @description Name of the column in the file. */
            column: string;
            /** @description Least number of each bin; null where there is none. */
            least: (number | null)[];
            /** @description Greatest number of each bin; null where there is none. */
            greatest: (number | null)[];
        };
        /** @description Layout by which a study is compared. */
        ComparedAnswer: {
            /** @description Place among the studies, 1 is best. */
            rank: number;
            /** @description Rank of the layout in its study's `layouts`. */
            layout_rank: number;
            /** @description Description of the layout, as in `12 films along y at the crown, one every 30 degrees`. */
            words: string;
            /** @description All its films. */
            film_count: number;
            /** @description Whether it keeps to the limits that the document asks for; null where it asks for none. */
            meets?: boolean | null;
            /** @description Certainty of the layout within its study. */
            verdict: components["schemas"]["Certainty"];
            /** @description Error of the contact angle in 95 of 100 contacts at the worst load, degrees. */
            angle_deg: components["schemas"]["ComparedFigure"];
            force_n?: components["schemas"]["ComparedFigure"] | null;
            /** @description Best layout of each number of films. */
            trade: components["schemas"]["TradeRow"][];
        };
        /** @description Figure of a layout beside the baseline's. */
        ComparedFigure: {
            /**
             * Format: double
             * @description The figure.
             */
            value: number;
            /**
             * Format: double
             * @description Claimed error of the figure; null where there is no coarser mesh.
             */
            error?: number | null;
            /**
             * Format: double
             * @description The figure minus the baseline's; null in the baseline.
             */
            difference?: number | null;
            /**
             * Format: double
             * @description Error of the difference; null where one of both isn't known.
             */
            difference_error?: number | null;
            verdict?: components["schemas"]["Verdict"] | null;
        };
        /** @description An index beside the baseline's. */
        ComparedIndex: {
            /**
             * Format: double
             * @description The index, percent.
             */
            gsi_percent?: number | null;
            /**
             * Format: double
             * @description Error of the index, percentage points.
             */
            error_percent?: number | null;
            /**
             * Format: double
             * @description The index minus the baseline's, percentage points; null in the baseline.
             */
            difference_percent?: number | null;
            /**
             * Format: double
             * @description Error of the difference, percentage points: less than both errors together, where both meshes err alike.
             */
            difference_error_percent?: number | null;
            verdict?: components["schemas"]["Verdict"] | null;
        };
        /** @description A location in one of the studies. */
        ComparedLocation: {
            /** @description The study. */
            study: string;
            /** @description P1, P2, ... */
            location: string;
            /** @description 1 is best. */
            rank: number;
            /** @description Whether the errors leave no doubt about this rank. */
            rank_certain: boolean;
            /**
             * Format: int64
             * @description Places lost since the baseline, negative when gained, where equal locations share the place of the first of them; null there, and where
             *     it hasn't the location.
             */
            rank_change?: number | null;
            rank_verdict?: components["schemas"]["Verdict"] | null;
            /** @description First-order index of the location's own depth for the x strain at the contact centre. */
            x: components["schemas"]["ComparedIndex"];
            /** @description First-order index of the location's own depth for the y strain at the contact centre. */
            y: components["schemas"]["ComparedIndex"];
        };
        /** @description A study of those compared. */
        ComparedStudy: {
            /** @description Identifier of the study. */
            id: string;
            /** @description Name of the study, or that of the design. */
            name: string;
            /** @description Settings of the design, by path; null for a study that belongs to no sweep. */
            set?: Record<string, unknown> | null;
            /** @description `queued`, `running`, `done`, `failed` or `cancelled`. */
            state: string;
            /** @description Reason why there is no result. */
            reason?: string | null;
            /** @description SHA-256 of its document. */
            spec_sha256?: string | null;
            /** @description Versions of the program and the solver. */
            version?: string | null;
            /** @description Mesh level. */
            level?: string | null;
            /**
             * Format: double
             * @description Vertical force at the means, N.
             */
            reaction_n?: number | null;
            /**
             * Format: double
             * @description Standard deviation of the x strain at the contact centre: the signal of a film there.
             */
            std_strain_x?: number | null;
            /**
             * Format: double
             * @description Standard deviation of the y strain there.
             */
            std_strain_y?: number | null;
            /** @description First of the ranking. */
            best?: string | null;
            /** @description Whether its errors leave no doubt about that. */
            best_certain?: boolean | null;
            answer?: components["schemas"]["ComparedAnswer"] | null;
            /**
             * Format: double
             * @description Angle between the units of that layout, degrees.
             */
            layout_spacing_deg?: number | null;
            /** @description Position of that layout's units. */
            layout_position?: string | null;
            cost?: components["schemas"]["StudyCost"] | null;
        };
        /** @description The table. */
        Comparison: {
            answer?: components["schemas"]["ComparisonAnswer"] | null;
            /** @description The study that differences are taken from; null when none of them has a result. */
            baseline?: string | null;
            /** @description The studies in the order asked for. */
            studies: components["schemas"]["ComparedStudy"][];
            /** @description Every location of every study that has a result, best first. */
            rows: components["schemas"]["ComparedLocation"][];
            /** @description Notes that the reader must know before believing the differences, whole sentences. */
            notes: string[];
        };
        /** @description The study that answers best. */
        ComparisonAnswer: {
            /** @description The study that answers best with its layout, and the next, in a sentence. */
            sentence: string;
            /** @description Certainty that no other study answers better. */
            verdict: components["schemas"]["Certainty"];
        };
        /**
         * @description Format of a comparison's file.
         * @enum {string}
         */
        ComparisonFormat: "csv" | "json" | "parquet";
        /**
         * @description Table of a comparison.
         * @enum {string}
         */
        ComparisonTable: "locations" | "designs";
        /** @description Simulated errors of contacts that differ from the usual one in a single quantity. */
        ContactError: {
            /** @description The quantity, as `layouts.contacts` names it; `noise`: none differs. */
            of: string;
            /** @description Name for people. */
            words: string;
            /**
             * Format: double
             * @description 95 % of contact angles are estimated better than this, degrees.
             */
            p95_angle_error_deg: number;
            /**
             * Format: double
             * @description Error of the vertical force, root mean square, N.
             */
            force_error_n: number;
        };
        /** @description Response surface of contacts as they come, and how far it is off at contacts that it hasn't seen. */
        ContactFindings: {
            /** @description Quantities with what their laws reach from and to, in words. */
            laws: string[];
            /** @description Contacts of all quantities at once by which it was judged. */
            checks: number;
            /**
             * Format: double
             * @description Root mean square error of the signals there within 30 degrees of the contact, over the crown's largest at that depth.
             */
            signal_error_rms: number;
            /**
             * Format: double
             * @description Claim that 95 % of the errors of signals at other such contacts are within this, over the crown's largest: Student's t for so few contacts. None of a study before claims.
             */
            signal_claim?: number | null;
            /**
             * Format: double
             * @description Largest error of a signal there, over the crown's largest.
             */
            signal_error_largest: number;
            /**
             * Format: double
             * @description Root mean square error of the signals' slopes over the contact's angle there, over the crown's steepest; none of a study that didn't judge them.
             */
            slope_error_rms?: number | null;
            /**
             * Format: double
             * @description Claim for such slopes.
             */
            slope_claim?: number | null;
            /**
             * Format: double
             * @description Largest error of such a slope.
             */
            slope_error_largest?: number | null;
            /**
             * Format: double
             * @description Root mean square error of the vertical force there, N.
             */
            force_error_n: number;
            /**
             * Format: double
             * @description Claim for the force, N.
             */
            force_claim_n?: number | null;
            /** @description Quantities whose laws reach beyond what could be solved, in words: what is drawn ends there. */
            short?: string[];
        };
        /** @description A number of solves with its range. */
        CountForecast: {
            /** @description Least count. */
            least: number;
            /** @description Likeliest count, as far as can be told. */
            expected: number;
            /** @description Greatest count. */
            most: number;
        };
        /** @description Names of the inflated crown's stretches. */
        CrownStretchFields_f64: {
            /** Format: double */
            crown_stretch_x: number;
            /** Format: double */
            crown_stretch_y: number;
        };
        /** @description The response at the means. */
        CutPoint: {
            /** @description Input values. */
            values: number[];
            /**
             * Format: double
             * @description Vertical force, N.
             */
            reaction_n: number;
            /**
             * Format: double
             * @description Height of the ground at the contact centre above the inflated outer radius, mm.
             */
            depth_mm: number;
            /**
             * Format: double
             * @description Outer radius after inflation, mm.
             */
            inflated_outer_radius_mm: number;
            /** @description Strains at P1, P2, ... */
            locations: components["schemas"]["LocationStrain"][];
            /** @description Newton residuals of its load steps. */
            residual_history: number[][];
        };
        /** @description Score that is left when a film dies. */
        DeadFilm: {
            /** @description The film, counted from 0. */
            film: number;
            /**
             * Format: double
             * @description Simulated 95th percentile of the angle's error without it, degrees.
             */
            simulated_p95_angle_error_deg?: number | null;
            /**
             * Format: double
             * @description Bound of the angle with a flat prior without it, root mean square, degrees.
             */
            bayes_angle_error_deg?: number | null;
        };
        /** @description Error with a film dead. */
        DeadFilmError: {
            /** @description The film, counted from 0. */
            film: number;
            /** @description Error of the estimates without it. */
            error: components["schemas"]["TrialError"];
        };
        /** @description Derivative of a response by one number of its scene. */
        Derivative: {
            /** @description Path of the number, as in `ground.depths_mm[2]`. */
            by: string;
        } & {
            [key: string]: unknown;
        };
        /** @description Designs by where they stand. */
        DesignCounts: {
            /** @description Wait for their turn. */
            queued: number;
            /** @description Are being solved. */
            running: number;
            /** @description Have a result. */
            done: number;
            /** @description Have none, and their study says why. */
            failed: number;
            /** @description Were cancelled. */
            cancelled: number;
        };
        /** @description Estimate of a design's cost. */
        DesignEstimate: {
            /** @description Name that tells it from the others. */
            name: string;
            /** @description Estimate of its study. */
            estimate: components["schemas"]["Estimate"];
        };
        /** @description A design of the sweep. */
        DesignView: {
            /**
             * Format: int64
             * @description Ordinal of the design in the sweep.
             */
            ordinal: number;
            /** @description Name that tells it from the others. */
            name: string;
            /** @description Values by path. */
            set: Record<string, unknown>;
            /** @description The study that answers for it. */
            study: components["schemas"]["StudySummary"];
        };
        /** @description Error with another drift of the readings. */
        DriftError: {
            /** @description The drift in words, as a share of a film's full scale. */
            drift: string;
            /** @description Error of the estimates then. */
            error: components["schemas"]["TrialError"];
            /** @description Error of the rows with a contact alone. */
            in_contact: components["schemas"]["TrialError"];
        };
        /** @description Error on another tire. */
        ElsewhereError: {
            /** @description Difference from the study's tire, in words. */
            tire: string;
            /** @description Whether estimators learnt from runs on it, too. */
            learnt: boolean;
            /** @description Error of the estimates there. */
            error: components["schemas"]["TrialError"];
        };
        /** @description Engines that a service has. */
        EngineList: {
            /** @description Each engine that clients may name. */
            engines: components["schemas"]["EngineView"][];
        };
        /**
         * @description Name of an engine.
         * @enum {string}
         */
        EngineName: "slurm" | "command";
        /** @description Engine, with the sweeps that it has or had. */
        EngineView: {
            /** @description Name of the engine, as `?engine=` has it. */
            name: components["schemas"]["EngineName"];
            /** @description Tasks of all its sweeps. */
            tasks: components["schemas"]["TaskCounts"];
            /** @description Sweeps whose tasks go on, and others, newest first. */
            sweeps: components["schemas"]["AwaySweep"][];
        };
        /** @description Change of what lists say of a study or a sweep: `name`, `archived` or both. What is left out stays as it is. */
        EntryChange: {
            /** @description Another name. The document, its hash and the result keep the one that was submitted. */
            name?: string;
            /** @description Whether lists leave it out. */
            archived?: boolean;
        };
        /** @description Sources of a layout's error of the contact angle at the study's own load: root mean squares over all contact angles, to first order, degrees. */
        ErrorSources: {
            /**
             * Format: double
             * @description Error by the noise of the readings.
             */
            noise_deg: number;
            /** @description Error by each input of the study, which the estimate takes at its mean. */
            inputs_deg: number[];
        };
        /** @description Estimate of what a study will cost, and be worth. */
        Estimate: {
            /** @description Equilibria to solve. */
            solves: components["schemas"]["SolveForecast"];
            wall_s?: components["schemas"]["Forecast"] | null;
            /**
             * Format: int64
             * @description Largest resident memory of the process, bytes.
             */
            peak_memory_bytes: number;
            /**
             * Format: int64
             * @description Room that its points and result take in the database, bytes; 0 in results of earlier versions.
             */
            database_bytes?: number;
            /** @description Accuracy that the answer is expected to have. */
            accuracy: components["schemas"]["ExpectedAccuracy"];
            /** @description Solves at once. */
            threads: number;
            /** @description Solves of this database by which the times were corrected for this machine; 0: the times are those of another machine. */
            measured_solves: number;
            /** @description Reasons why figures are ranges or null, whole sentences. */
            reasons: string[];
            /** @description Values that the physics makes unlikely, each with what may have been meant. */
            unlikely?: string[];
        };
        /** @description An estimator with its recipe. */
        EstimatorDetail: components["schemas"]["EstimatorSummary"] & {
            /** @description The recipe as it was submitted. */
            recipe: Record<string, unknown>;
            zero?: components["schemas"]["EstimatorZero"] | null;
        };
        /** @description Recordings to learn forces from, and how. */
        EstimatorDocument: {
            /** @description Free text; the first recording's file where it is left out. */
            name?: string;
            /** @description Recipe, as in `strainsite force fit`: the tables `columns`, `preprocess`, `features`, `models` and `validation`, every field with a default. */
            recipe?: components["schemas"]["RecipeDocument"];
            /** @description Recordings, one a run. */
            recordings: components["schemas"]["RecordingDocument"][];
        };
        /** @description A page of estimators, newest first. */
        EstimatorPage: {
            /** @description The estimators. */
            estimators: components["schemas"]["EstimatorSummary"][];
            /** @description Cursor of the next page; null on the last one. */
            next_cursor?: string | null;
        };
        /** @description An estimator in its queue, at work, or at its end. Times are RFC 3339, UTC. */
        EstimatorSummary: {
            /** @description UUID, ordered by time. */
            id: string;
            /** @description Free text. */
            name: string;
            /** @description State of the estimator. */
            state: components["schemas"]["State"];
            /** @description Reason why it failed, a sentence. */
            error?: string | null;
            /** @description Time at which it was submitted. */
            created: string;
            /** @description Time at which it was first started. */
            started?: string | null;
            /** @description Time at which it ended. */
            finished?: string | null;
            /** @description The forces' columns, N. */
            forces: string[];
            /** @description Recordings that it is learnt from. */
            recordings: components["schemas"]["RecordingFigures"][];
            progress?: components["schemas"]["FitProgress"] | null;
            estimate?: components["schemas"]["FitEstimate"] | null;
        };
        /** @description Zero that an estimator was given: what its signals are without a force. */
        EstimatorZero: {
            /** @description Recording without load that it is from. */
            file: string;
            /** @description Time at which it was given. */
            set: string;
            /** @description Signals' columns. */
            signals: string[];
            /** @description Each signal's median over the recording's rows without a force, in its own unit. */
            zero: number[];
        };
        /** @description A point that has an outcome. */
        EvaluationView: {
            /** @description Ordinal of the point in the plan. */
            ordinal: number;
            /** @description Hash of all that determines its outcome. */
            key: string;
            /** @description Mesh level. */
            level?: string | null;
            /** @description The inputs' values; null when its scene hasn't one of them. */
            values?: number[] | null;
            /**
             * Format: double
             * @description Vertical force, N; null without an equilibrium.
             */
            reaction_n?: number | null;
            /**
             * Format: double
             * @description Height of the ground at the contact centre above the inflated outer radius, mm; absent without an equilibrium.
             */
            depth_mm?: number | null;
            /** @description Strains at P1, P2, ...; null without an equilibrium. */
            locations?: components["schemas"]["LocationStrain"][] | null;
            /** @description Newton iterations; null without an equilibrium. */
            newton_iterations?: number | null;
            /**
             * Format: double
             * @description Wall-clock time of the solve, s.
             */
            wall_s: number;
            /** @description Reason why there is no equilibrium. */
            reason?: string | null;
            reached?: components["schemas"]["Reached"] | null;
        };
        /** @description Solved points. */
        Evaluations: {
            /** @description Points in the order of the plan; those after it are the same on a coarser mesh, or on the next rung of a climb. */
            evaluations: components["schemas"]["EvaluationView"][];
        };
        /** @description Accuracy that studies of this kind had where that was measured: the largest error of the ten indices that the paper's study ranks by, absolute. */
        ExpectedAccuracy: {
            /** @description Mesh and method of the answer, in a few words. */
            fidelity: string;
            /**
             * Format: double
             * @description Difference from the finest reference.
             */
            error_true?: number | null;
            /**
             * Format: double
             * @description Error that the answer claimed itself.
             */
            error_claimed?: number | null;
            /** @description Reason why there are no figures. */
            reason?: string | null;
        };
        /** @description Least and greatest value of a field. */
        Extremes: {
            /**
             * Format: double
             * @description Least value.
             */
            min: number;
            /**
             * Format: double
             * @description Greatest value.
             */
            max: number;
        };
        /** @description A node without an equilibrium. */
        FailedNode: {
            /**
             * Format: double
             * @description Value of the input.
             */
            value: number;
            /** @description Reason, a sentence. */
            reason: string;
        };
        /** @description A point without a response. */
        FailedPoint: {
            /** @description Ordinal in the plan. */
            ordinal: number;
            /** @description Input values. */
            values: number[];
            /** @description Cause of the failure. */
            cause: string;
        };
        /** @description A fault of a document: where it is, and what would be right. */
        Fault: {
            /** @description JSON pointer (RFC 6901) to the faulty value; empty for the document itself. */
            pointer: string;
            /** @description Sentence that says what is wrong and what would be right. */
            detail: string;
        };
        /**
         * @description A set of features, in the order of their sizes.
         * @enum {string}
         */
        FeatureSet: "raw" | "baseline" | "slopes" | "rolling" | "all" | "whole";
        /** @description A fidelity as it stands in documents. */
        FidelityReport: {
            /** @description Mesh level. */
            level: string;
            /** @description Method. */
            method: string;
            /** @description Gauss nodes for each input, at the start where the method adds some. */
            nodes: number;
            /** @description Points off the lines, at the start where the method adds some. */
            check_points: number;
        };
        /** @description Fields of films at one load. */
        FieldLoad: {
            /**
             * Format: double
             * @description Height of the ground above the inflated outer radius, mm.
             */
            depth_mm: number;
            /**
             * Format: double
             * @description Vertical force, N.
             */
            load_n?: number | null;
            /**
             * Format: double
             * @description Derivative of the force by the depth, N/mm.
             */
            force_slope_n_per_mm: number;
            /** @description Signal of each kind: a sample for each degree from the contact to the film, from -180 on. */
            signals: number[][];
            /** @description Derivative of the signals by the depth, per mm: as many samples. */
            slopes_per_mm: number[][];
            /** @description Variance of the signals over contacts as they come, beside that of the noise: as many samples; absent where contacts don't differ. */
            variances?: number[][];
        };
        /**
         * @description Format of a file.
         * @enum {string}
         */
        FileFormat: "csv" | "json" | "parquet" | "vtu" | "glb" | "svg";
        /** @description Glued films solved with the tire around the wheel, on undragged ground; errors are over the largest signal of their kind. */
        FilmAnglesReport: {
            /** @description Mesh level of the tire with a film. */
            level: string;
            /** @description Angles from the contact, degrees; films that lie askew on both sides of it. */
            angles_deg: number[];
            /** @description Loads, N. */
            loads_n: number[];
            /** @description Solves between them that tested the signals; 0 where none did, or where one of them has no equilibrium. */
            tested: number;
            /**
             * Format: double
             * @description Root mean square of their signals' errors; null where nothing was tested.
             */
            signal_rms?: number | null;
            /**
             * Format: double
             * @description The largest; null where nothing was tested.
             */
            signal_worst?: number | null;
            /**
             * Format: double
             * @description The largest error of a transfer alone, which is solved for films above the contact.
             */
            transfer_worst: number;
        };
        /**
         * @description Whether a film bears its mean tension, and its amplifier shows it.
         * @enum {string}
         */
        FilmCondition: "ok" | "beyond-yield" | "saturated" | "wrinkled";
        /** @description Estimated discretisation errors of a film, absolute: the change from the next coarser mesh, times Richardson's factor. */
        FilmError: {
            /**
             * Format: double
             * @description Error of the mean strain along.
             */
            mean_strain_1: number;
            /**
             * Format: double
             * @description Error of the mean strain across.
             */
            mean_strain_2: number;
            /**
             * Format: double
             * @description Error of the mean tension along, N/mm.
             */
            mean_tension_1_n_per_mm: number;
            /**
             * Format: double
             * @description Error of the mean tension across, N/mm.
             */
            mean_tension_2_n_per_mm: number;
            /**
             * Format: double
             * @description Error of the charge, nC.
             */
            charge_nc: number;
            /**
             * Format: double
             * @description Error of the open circuit's voltage, V.
             */
            open_circuit_v: number;
            /**
             * Format: double
             * @description Error of the amplifier's voltage, V.
             */
            output_v: number;
        };
        /** @description Signals of every kind of film at every load of a study's layouts. */
        FilmFields: {
            /** @description Unit of the signals: `strain`, or `V` of glued films. */
            unit: string;
            /** @description Length and width of every film, mm; null: points. */
            size_mm?: number[] | null;
            /** @description Errors of a reading. */
            noise: components["schemas"]["FilmNoise"];
            /** @description Kinds of film; the lists of a load are in their order. */
            kinds: components["schemas"]["FilmKindPlace"][];
            /** @description Loads that were reached. */
            loads: components["schemas"]["FieldLoad"][];
        };
        /** @description Place of a film in the section, and how it is turned. */
        FilmKindPlace: {
            /**
             * Format: double
             * @description Section angle from the crown, degrees.
             */
            phi_deg: number;
            /**
             * Format: double
             * @description Angle of its length to the circumferential direction, degrees: 0 is x, 90 is y.
             */
            angle_deg: number;
        };
        /**
         * @description Model of a film.
         * @enum {string}
         */
        FilmModel: "bare" | "transfer" | "coupled";
        /** @description Errors of a film's reading: the variance of one of signal h is floor² + (gain h)² + (place dh/du)². */
        FilmNoise: {
            /**
             * Format: double
             * @description Standard deviation whatever the signal, in its unit.
             */
            floor: number;
            /**
             * Format: double
             * @description Standard deviation of the gain, relative.
             */
            gain_std: number;
            /**
             * Format: double
             * @description Standard deviation of the film's place around the wheel, degrees.
             */
            place_std_deg: number;
        };
        /** @description The difference of two films at the crown, 30 degrees before and behind a point of the wheel, as the contact moves away from that point. */
        FilmPair: {
            /** @description Name of the tire. */
            tire: string;
            /** @description Model of the films. */
            film: components["schemas"]["FilmModel"];
            /** @description Direction of their length. */
            direction: string;
            /** @description Wheel angles from that point to the contact, degrees. */
            contact_deg: number[];
            /** @description Open circuit's voltage of the film that the contact comes to minus that of the other one, V; null where it isn't solved. */
            values: (number | null)[];
            monotone?: components["schemas"]["Trend"] | null;
            /**
             * Format: double
             * @description Share of the variance that a line explains.
             */
            linear_r2?: number | null;
        };
        /** @description A film of a layout. */
        FilmPlace: {
            /**
             * Format: double
             * @description Wheel angle, degrees.
             */
            theta_deg: number;
            /**
             * Format: double
             * @description Section angle from the crown, degrees.
             */
            phi_deg: number;
            /**
             * Format: double
             * @description Angle of its length to the circumferential direction, degrees: 0 is x, 90 is y.
             */
            angle_deg: number;
        };
        /** @description Signal that the contact adds to a film since inflation: means over its area, and what its amplifier reads of them. */
        FilmSignal: {
            /**
             * Format: double
             * @description Mean strain along: stretch relative to the inflated state minus one.
             */
            mean_strain_1: number;
            /**
             * Format: double
             * @description Mean strain across.
             */
            mean_strain_2: number;
            /**
             * Format: double
             * @description Mean tension along, N/mm.
             */
            mean_tension_1_n_per_mm: number;
            /**
             * Format: double
             * @description Mean tension across, N/mm.
             */
            mean_tension_2_n_per_mm: number;
            /**
             * Format: double
             * @description Change of curvature along, 1/mm, positive where the surface becomes more hollow towards the cavity.
             */
            curvature_change_1_per_mm: number;
            /**
             * Format: double
             * @description Change of curvature across, 1/mm.
             */
            curvature_change_2_per_mm: number;
            /**
             * Format: double
             * @description Charge, nC.
             */
            charge_nc: number;
            /**
             * Format: double
             * @description Capacitance of the film, pF.
             */
            capacitance_pf: number;
            /**
             * Format: double
             * @description Voltage where nothing draws charge, V.
             */
            open_circuit_v: number;
            /**
             * Format: double
             * @description Amplitude at the amplifier, for presses of its frequency, V.
             */
            output_v: number;
            /**
             * Format: double
             * @description Standard deviation of that by the amplifier's noise, the gain and the temperature, V.
             */
            output_std_v: number;
            /**
             * Format: double
             * @description Change of the charge by a rise of the cavity's pressure, nC per kPa.
             */
            charge_by_pressure_nc_per_kpa: number;
            /**
             * Format: double
             * @description Change of the charge by warming, nC per K.
             */
            charge_by_warming_nc_per_k: number;
            /**
             * Format: double
             * @description Time in which the reading of a held press falls to 1/e, s; absent where it stays.
             */
            time_constant_s?: number | null;
            /** @description Whether the film bears that, and the amplifier shows it. */
            state: components["schemas"]["FilmCondition"];
        };
        /** @description Least and greatest values over the whole film, relative to its unstressed state in the undeformed tire. */
        FilmState: components["schemas"]["StretchFields_Extremes"] & components["schemas"]["TensionFields_Extremes"] & components["schemas"]["FilmSignal"] & {
            bare?: components["schemas"]["FilmSignal"] | null;
            error?: components["schemas"]["FilmError"] | null;
        };
        /** @description Cost of a fit. */
        FitCost: {
            /** @description Candidates that were judged, of all forces. */
            candidates: number;
            /**
             * Format: double
             * @description Wall clock, s.
             */
            wall_s: number;
        };
        /** @description Estimate of what a fit takes. */
        FitEstimate: {
            /** @description Wall-clock time, s: by the sizes of the recordings, on another machine. */
            wall_s: components["schemas"]["Forecast"];
            /**
             * Format: int64
             * @description Bound of the memory, bytes.
             */
            peak_memory_bytes: number;
            /** @description Threads that it has. */
            threads: number;
        };
        /** @description Progress of a fit. */
        FitProgress: {
            /** @description Stage of the fit. */
            stage: components["schemas"]["FitStage"];
            /** @description Pieces of work of this stage that are done. */
            done: number;
            /** @description Pieces of work of this stage; 0 until that is known. */
            of: number;
        };
        /**
         * @description Stage of a fit.
         * @enum {string}
         */
        FitStage: "reading" | "start-value" | "judging" | "learning";
        /** @description Error of one force by a layout's films, with an estimator that is learnt from runs of a virtual rig. */
        ForceError: {
            /** @description `fx`: along the wheel, `fy`: across it, `fz`: vertical. */
            axis: string;
            /** @description The model that is chosen by left-out runs; `mean` where none is better than the training mean. */
            chosen: components["schemas"]["Kind"];
            /** @description The features it reads. */
            features: components["schemas"]["FeatureSet"];
            /** @description Whether its error on left-out runs is at most 95 % of the training mean's. */
            useful: boolean;
            /** @description The chosen model by random rows, by later rows, and by whole runs (cycles where there is one run). */
            splits: components["schemas"]["SplitError"][];
            /**
             * Format: double
             * @description Error on left-out runs over that on random rows, both as shares of the training mean's error on the same rows: how far a random split would have misled.
             *     Null of the training mean.
             */
            leak?: number | null;
            /** @description Error on runs that nobody learnt from: films have other gains there. */
            fresh: components["schemas"]["TrialError"];
            /** @description Error there of the rows with a contact alone. */
            in_contact?: components["schemas"]["TrialError"];
            /** @description Errors there where readings drift otherwise, learnt anew with each drift. */
            drift?: components["schemas"]["DriftError"][];
            alike?: components["schemas"]["AlikeError"] | null;
            dead?: components["schemas"]["DeadFilmError"] | null;
            /** @description Error there with films that lie elsewhere than those that were learnt from. */
            askew: components["schemas"]["AskewError"];
            /** @description Errors of these films on other tires. */
            elsewhere?: components["schemas"]["ElsewhereError"][];
            worst_contact?: components["schemas"]["WorstContact"] | null;
            /**
             * Format: double
             * @description Estimate of the least root of the mean squared error that one instant's readings allow, N: the bound of Cramer and Rao with what is known of the gait
             *     before, for films that hold their charge.
             */
            floor_n?: number | null;
            /** @description Reason why numbers are null. */
            reason?: string | null;
        };
        /** @description Findings of a virtual rig. */
        ForceFindings: {
            table?: components["schemas"]["TableReport"] | null;
            /** @description Prices of a force's error: for each force the layouts by which it is known better than by any with as many films or fewer. */
            price?: components["schemas"]["ForcePrice"][];
            /** @description Assumptions on the rig that no source states, whole sentences; empty where nothing was learnt. */
            assumed?: string[];
            /** @description Reasons why something is missing, whole sentences. */
            reasons?: string[];
        };
        /** @description A layout that knows a force better than all that have as many films or fewer. */
        ForcePrice: {
            /** @description `fx`: along the wheel, `fy`: across it, `fz`: vertical. */
            axis: string;
            /** @description Count of the layout's films. */
            films: number;
            /**
             * Format: double
             * @description Root of the mean squared error on runs that nobody learnt from, N.
             */
            rmse_n: number;
            /** @description The layout's rank. */
            layout_rank: number;
        };
        /** @description Findings for a force. */
        ForceReport: {
            /** @description Column of the force. */
            force: string;
            /** @description The model that estimates it; `mean` where nothing is better. */
            chosen: components["schemas"]["Kind"];
            /** @description The features it reads. */
            chosen_features: components["schemas"]["FeatureSet"];
            /**
             * Format: double
             * @description R2 of the chosen model where forces are rolled against signals: what chance would do.
             */
            rolled_r2?: number | null;
            beginnings?: components["schemas"]["BeginningsReport"] | null;
            /** @description All candidates, the chosen one first, then by their error. */
            models: components["schemas"]["ModelReport"][];
        };
        /** @description A figure with its range. */
        Forecast: {
            /**
             * Format: double
             * @description Least value.
             */
            least: number;
            /**
             * Format: double
             * @description Likeliest value, as far as can be told.
             */
            expected: number;
            /**
             * Format: double
             * @description Greatest value.
             */
            most: number;
        };
        /** @description Misses of a form at the check points: the witness of the method's error, and of how much of it two studies share. */
        FormMisses: {
            /** @description Number of the node of its input's rule at each coordinate of each check point, point after point. */
            nodes: number[];
            /** @description Strain minus the form's at each check point, over the standard deviation. */
            residuals: number[];
            /** @description Contributions of each of them to the error of a first-order index, input after input. */
            contributions: number[];
            /**
             * Format: double
             * @description Probability of the interactions, which the residuals stand for.
             */
            weight: number;
            /** @description Count of the form's numbers that were fitted to the check points. */
            fitted: number;
            /** @description Number of each check point's mirror image, whose strains are its own from the other end; absent where contact or inputs aren't symmetric. */
            images?: number[];
        };
        /** @description A layout that no other beats with as few films. */
        FrontLayout: {
            /** @description Count of its films. */
            film_count: number;
            /**
             * Format: double
             * @description Simulated 95th percentile of the angle's error at its worst load, degrees.
             */
            simulated_p95_angle_error_deg: number;
            /** @description Index in the list of layouts, from 0. */
            index: number;
        };
        /** @description Further designs of a sweep: `grid` or `designs`. */
        FurtherDesignsDocument: {
            /** @description Lists of values by path, as `geometry.wall_mm`: every combination is a design, the last path varying fastest. */
            grid?: {
                [key: string]: unknown[];
            };
            /** @description Designs, one by one. */
            designs?: components["schemas"]["DesignDocument"][];
        } & unknown;
        /** @description Time without a row. */
        GapLook: {
            /** @description Line in the file of the row before it. */
            line: number;
            /**
             * Format: double
             * @description Time of that row, s.
             */
            begin_s: number;
            /**
             * Format: double
             * @description Time to the next row, s.
             */
            length_s: number;
        };
        /** @description Intervals longer than ten typical ones. */
        GapsLook: {
            /** @description Count of them. */
            count: number;
            longest?: components["schemas"]["GapLook"] | null;
            /** @description The first 20, in the order of time. */
            first: components["schemas"]["GapLook"][];
        };
        /** @description A point of the inner surface and a direction there, as a strain gauge has it. */
        Gauge: {
            /**
             * Format: double
             * @description Wheel angle from the contact centre, degrees, positive in the rolling direction.
             */
            theta_deg: number;
            /**
             * Format: double
             * @description Section angle from the crown, degrees; from bead to bead.
             */
            phi_deg: number;
            /**
             * Format: double
             * @description Angle of the material line to the circumferential direction, drawn on the undeformed tire, degrees: 0 is x, 90 is y.
             */
            angle_deg: number;
        };
        /**
         * @description Estimated discretisation errors, absolute: root mean square of recovered minus raw values over the faces around the
         *     point.
         */
        GaugeError: {
            /**
             * Format: double
             * @description Error of the strain since inflation.
             */
            strain: number;
            /**
             * Format: double
             * @description Error of the stretch.
             */
            stretch: number;
            /**
             * Format: double
             * @description Error of the Green-Lagrange strain.
             */
            green_lagrange: number;
            /**
             * Format: double
             * @description Error of the von Mises stress, MPa.
             */
            von_mises_mpa: number;
        };
        /** @description Strain of a material line. */
        GaugeReading: components["schemas"]["Gauge"] & {
            /**
             * Format: double
             * @description The signal: stretch relative to the inflated state, minus one.
             */
            strain: number;
            /**
             * Format: double
             * @description Stretch relative to the undeformed tire.
             */
            stretch: number;
            /**
             * Format: double
             * @description Green-Lagrange strain relative to the undeformed tire, (stretch^2 - 1) / 2.
             */
            green_lagrange: number;
            /**
             * Format: double
             * @description Von Mises stress of the rubber at the point, MPa.
             */
            von_mises_mpa: number;
            error?: components["schemas"]["GaugeError"] | null;
        };
        /**
         * @description Effect of a note on the answer; gravest first.
         * @enum {string}
         */
        Grade: "changes-answer" | "bears-on-figure" | "for-the-record";
        /** @description A note with its grade. */
        GradedNote: {
            /** @description Effect on the answer. */
            grade: components["schemas"]["Grade"];
            /** @description Topic of the note. */
            about: components["schemas"]["Topic"];
            /** @description Whole sentences. */
            text: string;
        };
        /** @description A film of a layout; an angle that is left out is 0. */
        HandFilm: {
            /**
             * Format: double
             * @description Wheel angle, degrees.
             */
            theta_deg?: number;
            /**
             * Format: double
             * @description Section angle from the crown, degrees: one of the study's kinds.
             */
            phi_deg?: number;
            /**
             * Format: double
             * @description Angle of its length to the circumferential direction, degrees: 0 is x, 90 is y.
             */
            angle_deg?: number;
        };
        /** @description A layout film by film. */
        HandLayout: {
            /** @description Name of the layout, of at most 60 characters; its number when left out. */
            name?: string | null;
            /** @description Films of the layout, each at a place of its own. */
            films: components["schemas"]["HandFilm"][];
        };
        /** @description Layouts to be scored. */
        HandLayoutsDocument: {
            /** @description The layouts. */
            layouts: components["schemas"]["HandLayout"][];
            /** @description Whether errors are simulated beside the bounds, of 4 layouts at most; false when left out. */
            simulated?: boolean;
        };
        /** @description The service answers. */
        Health: {
            /** @description `ok` */
            status: string;
            /** @description Version of the program. */
            version: string;
        };
        /**
         * @description Whether a claim holds.
         * @enum {string}
         */
        Holds: "yes" | "no" | "uncertain";
        /** @description Index by which a location is ranked. */
        Index: {
            /** @description Name of the location. */
            location: string;
            /** @description Rank of the location. */
            rank: number;
            /** @description First-order indices for the x and the y strain, percent. */
            gsi_percent: (number | null)[];
            /** @description Claimed errors of the indices, percentage points. */
            error_percent: (number | null)[];
        };
        /** @description Parts of the error of an index, absolute. */
        IndexError: {
            /**
             * Format: double
             * @description Error of the mesh.
             */
            mesh?: number | null;
            /**
             * Format: double
             * @description Error of the quadrature rule.
             */
            quadrature?: number | null;
            /**
             * Format: double
             * @description Error of the decomposition.
             */
            decomposition?: number | null;
            /**
             * Format: double
             * @description Sum of the parts, the largest over the inputs; null where the mesh's part isn't known.
             */
            total?: number | null;
            /** @description Reason why a part is null. */
            reason?: string | null;
        };
        /** @description First-order indices over the dense grid. */
        IndexMap: {
            /** @description Angles of the columns from the contact centre, degrees. */
            theta_deg: number[];
            /** @description Angles of the rows from the crown, degrees. */
            phi_deg: number[];
            /** @description Layers, one per direction. */
            layers: components["schemas"]["MapLayer"][];
            /** @description Places of the points at the means. */
            shape: components["schemas"]["MapShape"];
        };
        /** @description The inflated tire before contact. */
        Inflated: components["schemas"]["CrownStretchFields_f64"] & {
            /**
             * Format: double
             * @description Outer radius at the crown, mm.
             */
            outer_radius_mm: number;
        };
        /** @description An input as it was understood. */
        InputReport: {
            /** @description Name of the input. */
            name: string;
            /** @description Path of the scene's field. */
            vary: string;
            /** @description Distribution as in the document. */
            distribution: Record<string, unknown>;
        };
        /** @description Share of an input. */
        InputShare: {
            /** @description Name of the input. */
            input: string;
            /**
             * Format: double
             * @description First-order index, 0 to 1.
             */
            index: number;
            /**
             * Format: double
             * @description Claimed error of the index; null where it isn't known.
             */
            error?: number | null;
        };
        /** @description Inputs in the order in which they matter for the strain at the contact centre. */
        InputsAnswer: {
            /** @description The inputs that matter most, in a sentence. */
            sentence: string;
            /** @description Certainty that the first matters most. */
            verdict?: components["schemas"]["Certainty"];
            /** @description Reason for the verdict, with the figures that decide. */
            reason?: string;
            /** @description Location at the contact centre. */
            location: string;
            /** @description Direction of the strain: the one that varies more, of those asked for. */
            direction: string;
            /** @description Share of each input, the greatest first. */
            shares: components["schemas"]["InputShare"][];
            /** @description Inputs that matter for what else the study is about: a film's volts, the layout's error of the angle. */
            beside?: components["schemas"]["InputsBeside"][];
        };
        /** @description Inputs in the order in which they matter for another quantity than a strain, to first order in all of them. */
        InputsBeside: {
            /** @description Name of the quantity. */
            quantity: string;
            /** @description The inputs that matter most, in a sentence. */
            sentence: string;
            /**
             * Format: double
             * @description Standard deviation of the quantity by all of them together, in its unit.
             */
            std: number;
            /** @description Unit of the quantity: `V`, `degrees`. */
            unit: string;
            /** @description Share of each input, the greatest first; of a layout's error also that of `noise`. */
            shares: components["schemas"]["InputShare"][];
        };
        /**
         * @description A kind of model, the simplest first.
         * @enum {string}
         */
        Kind: "mean" | "ridge" | "gpr" | "ann" | "blend";
        /** @description Knee: the number of units from which on more of them bring no more than their number. */
        Knee: {
            /**
             * Format: double
             * @description Section angle from the crown, degrees.
             */
            section_deg: number;
            /** @description Directions of the films of each unit. */
            films: string[];
            /** @description The number of units; null where even the most that were tried aren't enough. */
            units?: number | null;
            /**
             * Format: double
             * @description Worst bound times the root of the number of units of a dense ring, degrees.
             */
            dense_deg: number;
            /**
             * Format: double
             * @description Ratio of the worst bound times the root of the number of units every 60 degrees to that of a dense ring; null where they are blind.
             */
            of_60_deg?: number | null;
        };
        /** @description The layout that answers the question; where none is asked, the knee of the trade. */
        LayoutAnswer: {
            /** @description Rank in `layouts`. */
            rank: number;
            /** @description Description of the layout, as in `12 films along y at the crown, one every 30 degrees`. */
            words: string;
            /** @description Count of its units; of a layout without units of its films. */
            units: number;
            /** @description All its films. */
            film_count: number;
            /**
             * Format: double
             * @description 95 of 100 simulated contacts are estimated better than this at the worst load, degrees.
             */
            angle_error_deg: number;
            /**
             * Format: double
             * @description Claimed error of that, degrees; null where there is no coarser mesh.
             */
            error_deg?: number | null;
            /** @description Ranks of layouts that the errors can't tell from it. */
            tied_with: number[];
            /** @description Certainty that no layout that was tried answers better with as few films; where limits are asked, that it meets them and fewer films don't. */
            verdict: components["schemas"]["Certainty"];
            /** @description Reason for the verdict, with the figures that decide; where forces along and across are unknown, too, also what tells them from the angle. */
            reason: string;
        };
        /** @description Claimed errors of a layout's scores, each in the unit of its score. */
        LayoutError: {
            /**
             * Format: double
             * @description Error of the bound of the angle, worst angle, degrees.
             */
            worst_angle_error_deg?: number | null;
            /**
             * Format: double
             * @description Error of the bound of the angle, root mean square, degrees.
             */
            rms_angle_error_deg?: number | null;
            /**
             * Format: double
             * @description Error of the bound of the depth, mm.
             */
            worst_depth_error_mm?: number | null;
            /**
             * Format: double
             * @description Error of the simulated root mean square, degrees.
             */
            simulated_rms_angle_error_deg?: number | null;
            /**
             * Format: double
             * @description Error of the simulated 95th percentile, degrees.
             */
            simulated_p95_angle_error_deg?: number | null;
            /**
             * Format: double
             * @description Error of the force's error, N.
             */
            force_error_n?: number | null;
        };
        /** @description Findings of a study's layouts together: loads, knees, fronts, kinds of film. */
        LayoutFindings: {
            /** @description Mesh level of the fields, which is fine to 60 degrees from the contact. */
            level: string;
            /** @description Unit of films' signals: `strain`, or `V` of glued ones. Noise, weakest signals, candidates' signals and rings are in it. */
            unit: string;
            /** @description Length and width of the layouts' films, mm; absent of points. */
            size_mm?: number[] | null;
            /** @description Coarser level that shows their errors. */
            coarser_level?: string | null;
            /** @description The loads at which layouts are scored. */
            loads: components["schemas"]["LayoutLoad"][];
            contacts?: components["schemas"]["ContactFindings"] | null;
            films?: components["schemas"]["FilmAnglesReport"] | null;
            assumptions?: components["schemas"]["AssumptionFindings"] | null;
            /** @description Menu of layouts, where the document names none. */
            menu?: components["schemas"]["MenuFindings"];
            /** @description Layouts that no other beats with as few films, least films first. */
            front: components["schemas"]["FrontLayout"][];
            /**
             * Format: double
             * @description Kendall's tau between the order by simulated errors and that by the bound's worst error times the root of the number of films.
             */
            tau_of_bound?: number | null;
            /** @description Searches, and what they looked at. */
            searches?: components["schemas"]["LayoutSearch"][];
            /** @description Kinds of film, ranked by several criteria. */
            candidates: components["schemas"]["CandidateFilm"][];
            /** @description Films' signals around the wheel. */
            rings: components["schemas"]["StrainRing"][];
            /** @description Reasons why something is missing, whole sentences. */
            reasons?: string[];
        };
        /** @description A load at which layouts are scored. */
        LayoutLoad: {
            /**
             * Format: double
             * @description Height of the ground above the inflated outer radius, mm.
             */
            depth_mm?: number | null;
            /**
             * Format: double
             * @description Vertical force, N.
             */
            load_n?: number | null;
            /**
             * Format: double
             * @description Derivative of the force by the depth, N/mm.
             */
            force_slope_n_per_mm?: number | null;
            shear?: components["schemas"]["LoadShear"] | null;
            /** @description Knees: the number of units from which on each section angle and set of films is dense enough. */
            knees: components["schemas"]["Knee"][];
            /** @description Reason why there are no scores. */
            reason?: string | null;
        };
        /** @description Scores of a layout: how well it sees the contact, over all angles at which it can touch down. */
        LayoutScore: {
            /**
             * Format: double
             * @description Signal of the film that sees most, strain or volts of a glued one, at the contact angle where that is least.
             */
            weakest_signal?: number | null;
            /**
             * Format: double
             * @description Cramer-Rao bound of the contact angle, worst angle, degrees.
             */
            worst_angle_error_deg?: number | null;
            /**
             * Format: double
             * @description Cramer-Rao bound of the contact angle, root mean square over the angles, degrees.
             */
            rms_angle_error_deg?: number | null;
            /**
             * Format: double
             * @description Cramer-Rao bound of a uniform depth, worst angle, mm.
             */
            worst_depth_error_mm?: number | null;
            /**
             * Format: double
             * @description Bound of the contact angle's error with a flat prior, root mean square over the angles, degrees: finite where the others aren't.
             */
            bayes_angle_error_deg?: number | null;
            /**
             * Format: double
             * @description Error of the contact angle as estimated from noisy readings, root mean square, degrees.
             */
            simulated_rms_angle_error_deg?: number | null;
            /**
             * Format: double
             * @description Standard error of the root mean square by the number of simulated contacts, degrees.
             */
            simulated_rms_angle_error_deg_se?: number | null;
            /**
             * Format: double
             * @description 95 % of simulated contacts are estimated better than this, degrees.
             */
            simulated_p95_angle_error_deg?: number | null;
            /**
             * Format: double
             * @description Standard error of the 95th percentile by the number of simulated contacts, degrees.
             */
            simulated_p95_angle_error_deg_se?: number | null;
            /**
             * Format: double
             * @description Share of simulated contacts that are off by more than 20 degrees.
             */
            lost_share?: number | null;
            /**
             * Format: double
             * @description Error of the depth as estimated, root mean square, mm.
             */
            simulated_rms_depth_error_mm?: number | null;
            /**
             * Format: double
             * @description Error of the depth as a vertical force, N: by the slope of force over depth.
             */
            force_error_n?: number | null;
            /**
             * Format: double
             * @description Standard error of the force's error by the number of simulated contacts, N.
             */
            force_error_n_se?: number | null;
            alike?: components["schemas"]["AlikeContacts"] | null;
            dead?: components["schemas"]["DeadFilm"] | null;
            /** @description Errors of contacts that differ in nothing (`noise`) and in each quantity of `layouts.contacts` alone; absent where contacts don't differ. */
            contacts?: components["schemas"]["ContactError"][];
            /** @description Errors of what films tell of a contact beside angle and force; absent where contacts don't differ, or an estimate averages over them. */
            told?: components["schemas"]["ToldQuantity"][];
            shear?: components["schemas"]["ShearScore"] | null;
            /**
             * Format: double
             * @description Noise of each film assumed for the bounds, strain; null of glued films.
             */
            noise_strain?: number | null;
            /**
             * Format: double
             * @description Noise of each glued film assumed for the bounds, V; absent of bare ones.
             */
            noise_v?: number | null;
            error?: components["schemas"]["LayoutError"] | null;
            /** @description Reason why numbers are null. */
            reason?: string | null;
        };
        /** @description Search for layouts, and what it looked at. */
        LayoutSearch: {
            /** @description Films of the layouts. */
            films: number;
            /** @description Places that a film may have. */
            places: number;
            /** @description `exhaustive`, or `greedy and exchange`. */
            method: string;
            /** @description Criterion of the search: `bound`, or `interval errors`, which count contacts that are mistaken for others, too. */
            criterion: string;
            /** @description Layouts whose criterion was computed. */
            looked_at: number;
            /**
             * Format: double
             * @description Bound of the angle with a flat prior of the best one, root mean square over angles and loads, degrees; null where no layout of so many films was found that has
             *     room.
             */
            bayes_angle_error_deg?: number | null;
            /** @description Films of the best layout. */
            best: components["schemas"]["FilmPlace"][];
        };
        /** @description Ranked layouts. */
        Layouts: {
            /** @description Best first. */
            layouts: components["schemas"]["RankedLayout"][];
            findings?: components["schemas"]["LayoutFindings"] | null;
        };
        /** @description Part that the model leaves out. */
        LeftOut: {
            /** @description Name of the part, as in `model.left_out`. */
            what: string;
            /** @description Reason for leaving it out, as in `model.left_out`. */
            why: string;
            /**
             * Format: double
             * @description Largest change of a strain at P1, P2, ... over the largest strain of its direction.
             */
            effect: number;
            /** @description Sentence that says what it would do. */
            sentence: string;
        };
        /** @description Rows that weren't learnt from. */
        LeftOutForces: {
            /** @description Rows that were left out, one list a force. */
            forces: components["schemas"]["LeftOutRows"][];
        };
        /** @description Rows that the chosen model of a force hadn't learnt from: truth, estimate and interval. */
        LeftOutRows: {
            /** @description The force's column. */
            force: string;
            /** @description Each row's run, by its place among the recordings. */
            run: number[];
            /** @description Each row's time, s. */
            time_s: number[];
            /** @description Measured force, N. */
            truth_n: number[];
            /** @description Estimated force, N. */
            estimate_n: number[];
            /** @description The interval's low end, N. */
            low_n: number[];
            /** @description The interval's high end, N. */
            high_n: number[];
        };
        /** @description A solve under way. */
        LiveSolve: components["schemas"]["SolveProgress"] & {
            /** @description Ordinal of its point in the plan. */
            ordinal: number;
        };
        /** @description A layout's scores at one load. */
        LoadScore: {
            /**
             * Format: double
             * @description Height of the ground above the inflated outer radius, mm.
             */
            depth_mm?: number | null;
            /**
             * Format: double
             * @description Vertical force, N.
             */
            load_n?: number | null;
            /** @description The scores. */
            score: components["schemas"]["LayoutScore"];
        };
        /** @description Findings by dragging the ground a little at a load. */
        LoadShear: {
            /** @description Forces along the wheel and across it by the shifts that way, N/mm. */
            slopes_n_per_mm: number[];
            /**
             * Format: double
             * @description Force from which the ground slides: the coefficient of friction times the load, N.
             */
            sliding_n: number;
        };
        /** @description Left-out runs that begin under a load. */
        LoadedReport: {
            /**
             * Format: double
             * @description Share of the run's largest force.
             */
            share: number;
            /**
             * Format: double
             * @description Mean load at the beginning, N.
             */
            load_n: number;
            /**
             * Format: double
             * @description N
             */
            rmse_n: number;
            /**
             * Format: double
             * @description RMSE of the same rows of the runs as recorded, N.
             */
            recorded_rmse_n: number;
        };
        /** @description Estimated discretisation errors at a location, absolute: see [`crate::gauge::GaugeError`]. */
        LocationError: {
            /**
             * Format: double
             * @description Error of the circumferential strain.
             */
            strain_x: number;
            /**
             * Format: double
             * @description Error of the meridional strain.
             */
            strain_y: number;
            /**
             * Format: double
             * @description Error of the von Mises stress, MPa.
             */
            von_mises_mpa: number;
        };
        /** @description Strain at a named location. */
        LocationStrain: {
            /** @description P1, P2, ... */
            name: string;
            /**
             * Format: double
             * @description Angle from the contact centre, degrees, positive in the rolling direction.
             */
            theta_deg: number;
            /**
             * Format: double
             * @description Circumferential strain.
             */
            strain_x: number;
            /**
             * Format: double
             * @description Meridional strain.
             */
            strain_y: number;
            /**
             * Format: double
             * @description Von Mises stress of the rubber at the inner surface, MPa.
             */
            von_mises_mpa: number;
            error?: components["schemas"]["LocationError"] | null;
        };
        /** @description Ranked locations. */
        Locations: {
            /** @description Best first. */
            locations: components["schemas"]["RankedLocation"][];
        };
        /** @description An address that lets a browser in. */
        LoginLink: {
            /** @description Path to be opened once, after the service's own address. */
            path: string;
        };
        /** @description A sample that stands alone. */
        LoneSample: {
            /** @description Line in the file. */
            line: number;
            /**
             * Format: double
             * @description Time, s.
             */
            time_s: number;
            /**
             * Format: double
             * @description Value.
             */
            value: number;
        };
        /** @description Samples that stand alone. */
        LoneSamples: {
            /** @description Count of them. */
            count: number;
            /** @description The first 20. */
            first: components["schemas"]["LoneSample"][];
        };
        /** @description Look at recordings: what each column is taken for, and what stands in it. */
        Look: {
            /** @description Recordings that can be read, in the order in which they were given. */
            recordings: components["schemas"]["RecordingLook"][];
            /** @description Faults of those that can't be, as learning from them tells. */
            faults: components["schemas"]["Fault"][];
            /** @description Reasons for which nothing would be learnt from them, though they can be read. */
            refusals: components["schemas"]["Fault"][];
        };
        /** @description Recordings to look at, and how their columns are read. */
        LookDocument: {
            /** @description Recipe, as in `strainsite force fit`: its `columns` say what is read, its `preprocess` whether signals may be empty. */
            recipe?: components["schemas"]["RecipeDocument"];
            /** @description Recordings, one a run. */
            recordings: components["schemas"]["RecordingDocument"][];
        };
        /** @description A direction of the map; all lists are rows x columns. */
        MapLayer: {
            /** @description `x` or `y`. */
            direction: string;
            /** @description Strain at the cut point. */
            strain: number[];
            /** @description Standard deviation of the strain. */
            std: (number | null)[];
            /** @description First-order index per input, in the order of the inputs, each rows x columns. */
            first_order: (number | null)[][];
            /** @description Estimated error of the first-order indices, the largest over the inputs, rows x columns. */
            error: (number | null)[];
            /** @description Estimated error of the first-order index per input, in the order of the inputs, each rows x columns. */
            first_order_error: (number | null)[][];
            /** @description Total index per input, in the order of the inputs, each rows x columns: without errors of their own. */
            total: (number | null)[][];
            /** @description `ok`, `constant`, `product-form-broken` or `unusable`, rows x columns. */
            status: string[];
        };
        /** @description Places of the points of a map: x in the rolling direction, y along the axle, z upward, from the wheel's centre. */
        MapShape: {
            /** @description Positions in the inflated state before contact, mm, rows x columns. */
            inflated_mm: number[][];
            /** @description Displacements from there to the equilibrium, mm, rows x columns. */
            displacement_mm: number[][];
        };
        /** @description A layer of the map; lists are rows x columns, all angles of the first row first. */
        MapView: {
            /** @description x circumferential, y meridional. */
            direction: string;
            /** @description Name of the input. */
            input: string;
            /** @description Angles of the columns from the contact centre, degrees. */
            theta_deg: number[];
            /** @description Angles of the rows from the crown, degrees. */
            phi_deg: number[];
            /** @description First-order index of the input. */
            first_order?: (number | null)[] | null;
            /** @description Total index of the input, without an error of its own; null unless it is asked for (`index=total`). */
            total?: (number | null)[] | null;
            /** @description Standard deviation of the strain. */
            std: (number | null)[];
            /** @description Strain at the means. */
            strain: number[];
            /** @description Error of the first-order index, absolute. */
            error: (number | null)[];
            /** @description `ok`, `constant`, `product-form-broken` or `unusable`. */
            status: string[];
        };
        /** @description A model that is part of a blend. */
        MemberReport: {
            /** @description The model. */
            model: components["schemas"]["Kind"];
            /** @description The features it reads. */
            features: components["schemas"]["FeatureSet"];
        };
        /** @description Layouts that were tried, and those of the menu that aren't in the list. */
        MenuFindings: {
            /** @description Count of those that weren't simulated: their bounds show that others with as few films are better. */
            screened: number;
            /** @description Count of those whose films have no room. */
            without_room: number;
            /** @description Sentence that says what was tried. */
            sentence: string;
        };
        /** @description Indices as far as the values tell, and the points that are still to be run. */
        ModelAnalysis: {
            /** @description Names of the inputs. */
            inputs: string[];
            /** @description Outputs with their indices; none while the method's first points lack values. */
            outputs: components["schemas"]["ModelOutput"][];
            /** @description Points that have values. */
            evaluations: number;
            /** @description Points that are still to be run; 0 at the end. */
            wanted: number;
            /** @description Points that are still to be run. */
            points: components["schemas"]["ModelPoints"];
            /** @description Advice, a sentence, where the indices say little or points are missing. */
            advice?: string | null;
        };
        /** @description Errors of first-order indices: what they are off by at most, in all and in parts. */
        ModelIndexError: {
            /**
             * Format: double
             * @description Error of the nodes' number.
             */
            quadrature?: number | null;
            /**
             * Format: double
             * @description Error of the form.
             */
            decomposition?: number | null;
            /**
             * Format: double
             * @description Error of the sample.
             */
            sampling?: number | null;
            /**
             * Format: double
             * @description Share of the variance that is rounding of doubles.
             */
            floor: number;
            /**
             * Format: double
             * @description Error of runs that failed.
             */
            lost?: number | null;
            /**
             * Format: double
             * @description Error of digits that weren't printed.
             */
            rounding?: number | null;
            /**
             * Format: double
             * @description Error of the worst index, all parts together.
             */
            total?: number | null;
            /** @description Error of each input's index. */
            by_input?: number[] | null;
        };
        /** @description Indices of an output, one an input. */
        ModelOutput: {
            /** @description Name of the output. */
            name: string;
            /**
             * Format: double
             * @description Mean, in the output's units.
             */
            mean?: number | null;
            /**
             * Format: double
             * @description Variance, in the output's units squared.
             */
            variance?: number | null;
            /** @description First-order index of each input: its share of the variance alone. */
            first_order?: number[] | null;
            /** @description Total index of each input: its share with all that it interacts in. */
            total?: number[] | null;
            /** @description Share of each pair of inputs alone, in the order 12, 13, .., 23, ..; null where the method has none. */
            second_order?: number[] | null;
            /** @description End of the analysis: `ok`, `constant`, `product-form-broken` or `unusable`. */
            status: string;
            /** @description Reason why a number is missing, and what else a reader should know. */
            reason?: string | null;
            /** @description Form behind the indices. */
            method: string;
            /** @description First-order indices of the product form where it is broken. */
            mdrm_first_order?: number[] | null;
            /** @description Total indices of the product form where it is broken. */
            mdrm_total?: number[] | null;
            /** @description Errors of the first-order indices. */
            error: components["schemas"]["ModelIndexError"];
        };
        /** @description Points of a model, each a value of every input. */
        ModelPoints: {
            /** @description Number of each point, by which its values are sent. */
            ids: number[];
            /** @description Values of the inputs at each point, in the inputs' units. */
            rows: number[][];
        };
        /** @description Report of a candidate. */
        ModelReport: {
            /** @description The model. */
            model: components["schemas"]["Kind"];
            /** @description The features it reads. */
            features: components["schemas"]["FeatureSet"];
            /** @description The models whose median a blend is; left out of others. */
            members?: components["schemas"]["MemberReport"][];
            /** @description Figures on the split that chooses. */
            validation: components["schemas"]["SplitReport"];
            /** @description Figures on every split; null where there is none, the reason in the notes. */
            splits: components["schemas"]["SplitReports"];
            /**
             * Format: double
             * @description RMSE on the strictest split over that on the random one: how far a random split would have misled.
             */
            leak_factor?: number | null;
            /** @description Whether its error is at most 95 % of the training mean's on the split that chooses. */
            better_than_mean: boolean;
        };
        /** @description Summary of a model: what was modelled and what was left out. */
        ModelSummary: {
            /** @description `3d`, `3d-half` or `3d-quarter`. */
            dimension: string;
            /** @description Mesh level. */
            level: string;
            /** @description Number of solid elements. */
            elements: number;
            /** @description Free displacement unknowns. */
            dofs: number;
            /** @description Parts of the scene in the model. */
            modelled: components["schemas"]["Choice"][];
            /** @description Parts of the scene left out. */
            left_out: components["schemas"]["Choice"][];
        };
        /** @description Indices of one strain. */
        Output: {
            /** @description P1, P2, ... */
            location: string;
            /** @description `x` circumferential, `y` meridional. */
            direction: string;
            /**
             * Format: double
             * @description Mean strain.
             */
            mean?: number | null;
            /**
             * Format: double
             * @description Standard deviation of the strain.
             */
            std?: number | null;
            /** @description First-order index of each input. */
            first_order?: number[] | null;
            /** @description Total index of each input. */
            total?: number[] | null;
            /** @description Form that gave `first_order` and `total`: `mdrm`, `additive`, `shifted`, `corrected`, `bivariate`, `tensor`, `pce` or `saltelli`. */
            method: string;
            /** @description `ok`, `constant`, `product-form-broken` or `unusable`. */
            status: string;
            /** @description Reason why the status isn't `ok`. */
            reason?: string | null;
            /** @description Indices that M-DRM gave, when its product form is broken. */
            mdrm_first_order?: number[] | null;
            /** @description Error of the first-order indices, absolute. */
            error: components["schemas"]["IndexError"];
            coarser?: components["schemas"]["CoarserIndices"] | null;
            misses?: components["schemas"]["FormMisses"] | null;
        };
        /** @description The location that ranks first. */
        PlaceAnswer: {
            /** @description All that share the first rank or, where the verdict is tied, can't be told from the first. */
            names: string[];
            /** @description Direction of the strain, of those asked for, whose index is larger there. */
            direction: string;
            /**
             * Format: double
             * @description First-order index of the location's own depth for that strain at the contact centre, 0 to 1.
             */
            index: number;
            /**
             * Format: double
             * @description Claimed error of the score; null where it isn't known.
             */
            error?: number | null;
            /** @description Certainty of the first rank, by what locations are ranked by. */
            verdict: components["schemas"]["Certainty"];
            /** @description Reason for the verdict, with the figures that decide. */
            reason: string;
            /** @description The place in a sentence. */
            sentence: string;
        };
        /** @description A document to start from. */
        Preset: {
            /** @description Name in `scene = { preset = ... }`. */
            name: string;
            /** @description Title of the scene. */
            title: string;
            /** @description The document. */
            document: Record<string, unknown>;
            /** @description Purpose of the scene. */
            comment: string;
        };
        /** @description The documents that ship. */
        Presets: {
            /** @description Whole studies. */
            studies: components["schemas"]["Preset"][];
            /** @description Scenes alone. */
            scenes: components["schemas"]["Preset"][];
        };
        /** @description A study's places and layouts on the draft mesh. It claims nothing: no error is known. */
        Preview: {
            /** @description Claim of the preview: `none`. */
            claim: string;
            /** @description Mesh level: `draft`. */
            level: string;
            /**
             * Format: double
             * @description Time from the request to the answer, s.
             */
            wall_s: number;
            /** @description Points that were solved. */
            solves: number;
            /** @description Parts that the study would have beside, whole sentences. */
            left_out: string[];
            /** @description Inputs that varied. */
            inputs: components["schemas"]["InputReport"][];
            answer?: components["schemas"]["Answer"] | null;
            /** @description Ranked locations. */
            locations: components["schemas"]["RankedLocation"][];
            /** @description The response at the means. */
            cut_point: components["schemas"]["CutPoint"];
            map?: components["schemas"]["IndexMap"] | null;
            /** @description Notes that the user must know before believing the numbers, whole sentences. */
            notes: string[];
        };
        /** @description Problem that a client is told when a request can't be answered: RFC 9457. */
        ProblemDocument: {
            /** @description Kind of problem: `about:blank`, the status says it. */
            type: string;
            /** @description The status in words. */
            title: string;
            /**
             * Format: int32
             * @description The HTTP status.
             */
            status: number;
            /** @description A sentence for people. */
            detail: string;
            /** @description Every fault of the document, with its JSON pointer. */
            errors?: components["schemas"]["Fault"][];
            /** @description The request's identifier, as in the header `x-request-id` and in the log. */
            request_id?: string | null;
        };
        /** @description Question that a study's layouts answer: the best with so many films, or the fewest films that keep errors within limits. */
        Question: {
            /** @description Most films of a layout, those that are glued on already among them. */
            films?: number | null;
            /**
             * Format: double
             * @description Largest error of the contact angle that is allowed, degrees: of 95 in 100 contacts at the worst load.
             */
            angle_deg?: number | null;
            /**
             * Format: double
             * @description Largest error of the vertical force that is allowed, N: root mean square at the worst load.
             */
            force_n?: number | null;
            /**
             * Format: double
             * @description Most that a layout may cost, in the currency of `film_cost` and `channel_cost`.
             */
            cost?: number | null;
            /**
             * Format: double
             * @description Cost of a film that isn't glued on already.
             */
            film_cost?: number | null;
            /**
             * Format: double
             * @description Cost of a channel of the amplifier: every film has one.
             */
            channel_cost?: number | null;
        };
        /** @description A layout in the ranking. */
        RankedLayout: {
            /** @description 1 is best. Layouts of equal score share the rank of the first of them. */
            rank: number;
            /** @description Whether the errors leave no doubt about its place; absent of one that wasn't ranked. */
            rank_certain?: boolean | null;
            /** @description Name of a layout that was listed film by film, or found by the search; absent of a regular one. */
            name?: string | null;
            /**
             * Format: double
             * @description Angle between neighbouring units, degrees; null of a layout without units.
             */
            spacing_deg?: number | null;
            /**
             * Format: double
             * @description Angle of the first unit from the mark, degrees, where no film may lie there; absent of 0.
             */
            turn_deg?: number | null;
            /** @description Number of units; of a layout without units its number of films. */
            units: number;
            /** @description Meridional position: a name, an angle such as `30 deg`, or `mixed`. */
            position: string;
            /** @description Directions of the films of each unit: `x`, `y`, or an angle such as `45`. */
            films: string[];
            /** @description Whether the films of a unit are spread evenly between two units. */
            staggered?: boolean;
            /** @description All films of the wheel. */
            film_count: number;
            /** @description The films of a layout without units, one by one. */
            places?: components["schemas"]["FilmPlace"][];
            /** @description Figures that may be off by more than a fifth, in words. */
            doubt?: string | null;
            /** @description Scores at the load where the angle's error is largest. */
            score: components["schemas"]["LayoutScore"];
            /**
             * Format: double
             * @description Load of these scores, N.
             */
            worst_load_n?: number | null;
            worst_force?: components["schemas"]["WorstForce"] | null;
            /**
             * @description Errors of contacts that differ in nothing and in each quantity of `layouts.contacts` alone, each at the load where it is largest; absent where contacts don't
             *     differ.
             */
            contacts?: components["schemas"]["ContactError"][];
            /**
             * @description Errors of what films tell of a contact beside angle and force, each at the load where it is largest; absent where contacts don't differ, or an estimate
             *     averages over them.
             */
            told?: components["schemas"]["ToldQuantity"][];
            /** @description Scores at every load. */
            loads: components["schemas"]["LoadScore"][];
            error_sources?: components["schemas"]["ErrorSources"] | null;
            /** @description Errors of the forces along, across and vertical on a virtual rig; absent where the study has none, and of layouts that a search found. */
            force_error?: components["schemas"]["ForceError"][] | null;
        };
        /** @description One candidate location in the ranking. */
        RankedLocation: {
            /** @description P1, P2, ... */
            name: string;
            /** @description The input that is this location's own: the depth of the station below it. */
            input: string | null;
            /** @description 1 is best. Equal locations, as mirror images are, share the rank of the first of them, and follow each other in the order of their names. */
            rank: number;
            /**
             * Format: double
             * @description 100 times the first-order index of this location's own depth for the x strain at the centre.
             */
            gsi_x_percent: number | null;
            /**
             * Format: double
             * @description 100 times the first-order index of this location's own depth for the y strain at the centre.
             */
            gsi_y_percent: number | null;
            /**
             * Format: double
             * @description Error of `gsi_x_percent`, percentage points.
             */
            gsi_x_error_percent: number | null;
            /**
             * Format: double
             * @description Error of `gsi_y_percent`, percentage points.
             */
            gsi_y_error_percent: number | null;
            /**
             * Format: double
             * @description Mean over the x strains at all locations.
             */
            mean_gsi_x_percent: number | null;
            /**
             * Format: double
             * @description Mean over the y strains at all locations.
             */
            mean_gsi_y_percent: number | null;
            /**
             * Format: double
             * @description For the x strain at this location itself.
             */
            own_gsi_x_percent: number | null;
            /**
             * Format: double
             * @description For the y strain at this location itself.
             */
            own_gsi_y_percent: number | null;
            /**
             * Format: double
             * @description Index by M-DRM for `gsi_x_percent`, valid or not: the paper's Table 2 as the paper computed it.
             */
            mdrm_gsi_x_percent: number | null;
            /**
             * Format: double
             * @description Index by M-DRM for `gsi_y_percent`, valid or not: the paper's Table 2 as the paper computed it.
             */
            mdrm_gsi_y_percent: number | null;
            /** @description Rank by the x strain alone, which equal locations share. */
            rank_x: number | null;
            /** @description Rank by the y strain alone, which equal locations share. */
            rank_y: number | null;
            /** @description Whether the errors leave no doubt about this rank, which equal locations share. */
            rank_certain: boolean;
        };
        /** @description Loads that a failed solve got to. */
        Reached: {
            /**
             * Format: double
             * @description Internal pressure of the last equilibrium, MPa.
             */
            pressure_mpa: number;
            /** @description Station depths of the last equilibrium, mm. */
            depths_mm?: number[];
            /**
             * Format: double
             * @description Vertical force of the ground at the last equilibrium, N, where it is to press with one.
             */
            load_n?: number | null;
        };
        /** @description The service can work. */
        Readiness: {
            /** @description `ready` */
            status: string;
        };
        /** @description The whole recipe. */
        RecipeDocument: {
            /**
             * @description Columns that are meant.
             * @default {}
             */
            columns: components["schemas"]["ColumnsDocument"];
            /**
             * @description Treatment of signals before anything is learnt.
             * @default {
             *       "start_value": "auto",
             *       "start_rows": 1,
             *       "turn_sign": false,
             *       "smooth_rows": 1,
             *       "suspect_rows": "keep",
             *       "scale": "standardise",
             *       "bad_rows": "null"
             *     }
             */
            preprocess: components["schemas"]["PreprocessDocument"];
            /**
             * @description Features that models are given of the signals.
             * @default {
             *       "sets": [
             *         "raw",
             *         "slopes",
             *         "rolling",
             *         "all"
             *       ],
             *       "window_rows": 10,
             *       "baseline_s": 1.5
             *     }
             */
            features: components["schemas"]["FeaturesDocument"];
            /**
             * @description Models that are tried, and how.
             * @default {
             *       "kinds": [
             *         "ridge",
             *         "gpr",
             *         "ann",
             *         "blend"
             *       ],
             *       "gpr": {
             *         "lengths": "shared",
             *         "line": true,
             *         "restarts": 50,
             *         "search_rows": 600,
             *         "most_rows": 3000
             *       },
             *       "ann": {
             *         "layers": [
             *           24,
             *           12
             *         ],
             *         "activation": "tanh",
             *         "output": "linear",
             *         "loss": "mse",
             *         "decay": 0.001,
             *         "iterations": 300,
             *         "networks": 3
             *       },
             *       "seed": 1
             *     }
             */
            models: components["schemas"]["ModelsDocument"];
            /**
             * @description Validation that judges them.
             * @default {
             *       "time_constant_s": 0
             *     }
             */
            validation: components["schemas"]["ValidationDocument"];
        };
        /** @description A recording as text. */
        RecordingDocument: {
            /** @description Name that faults, reports and plots give it. */
            file: string;
            /** @description CSV: a header, then a row a line: seconds, signals, and forces where they were measured. */
            text: string;
        };
        /** @description Figures of a recording. */
        RecordingFigures: {
            /** @description File of the recording. */
            file: string;
            /** @description Count of its rows. */
            rows: number;
            /** @description Rows with at least one force. */
            labelled: number;
            /** @description Count of its cycles. */
            cycles: number;
            /**
             * Format: double
             * @description Rows a second, pauses apart.
             */
            rate_hz?: number | null;
            /** @description Hash of its text. */
            sha256: string;
        };
        /** @description Recording that was looked at. */
        RecordingLook: {
            /** @description Name of the file. */
            file: string;
            /** @description Count of its rows. */
            rows: number;
            /**
             * Format: double
             * @description Time of the first row, s.
             */
            begin_s: number;
            /**
             * Format: double
             * @description Time from the first row to the last, s.
             */
            duration_s: number;
            /**
             * Format: double
             * @description Rows a second; null of one row.
             */
            rate_hz?: number | null;
            /** @description Intervals longer than ten typical ones. */
            gaps: components["schemas"]["GapsLook"];
            /** @description Cycles, by the recipe's rule. */
            cycles: number;
            /** @description Rows with at least one force. */
            labelled: number;
            /** @description Columns in the order of the file. */
            columns: components["schemas"]["ColumnLook"][];
            /** @description Sentences on the recording as a whole: forces that are converted, or that there are none. */
            notes: string[];
            /** @description Columns over time, for plots; left out where nobody asked for them. */
            series?: components["schemas"]["RecordingSeries"];
        };
        /** @description Columns of a recording over time, in bins of equal length from its first row to its last. */
        RecordingSeries: {
            /**
             * Format: double
             * @description Length of a bin, s.
             */
            bin_s: number;
            /** @description Columns with numbers, but for the time. */
            columns: components["schemas"]["ColumnSeries"][];
        };
        /** @description Reason why a node handed in nothing. */
        Refusal: {
            /** @description Name of the node. */
            node: string;
            /** @description A sentence. */
            because: string;
        };
        /** @description The report of a fit. */
        Report: {
            /** @description Recordings that were learnt from. */
            recordings: components["schemas"]["RecordingFigures"][];
            /** @description Findings for each force. */
            forces: components["schemas"]["ForceReport"][];
            /** @description Promise of the intervals, a sentence. */
            promise: string;
            /** @description Notes that a reader should know before believing it, a sentence each. */
            notes: string[];
            /** @description Cost of the fit. */
            cost: components["schemas"]["FitCost"];
        };
        /**
         * @description Strains, forces and diagnostics of one equilibrium.
         *
         *     Strains are stretches relative to the inflated state minus one, on the inner surface; x circumferential,
         *     y meridional.
         */
        Response: {
            /**
             * Format: double
             * @description Force of the ground on the whole tire along the ground's normal, N.
             */
            reaction_n: number;
            /**
             * @description Force of the ground on the whole tire, N, in the wheel's frame: along the wheel (x), along the axle (y) and in the wheel's plane upwards (z, the reaction of
             *     an upright wheel). Friction pulls the way that the ground is dragged. Absent where the solver doesn't tell.
             */
            force_n?: number[] | null;
            /** @description Moment of the ground's forces about the wheel's centre, N mm, in the wheel's frame: x, y, z as `force_n`. Absent where the solver doesn't tell. */
            moment_nmm?: number[] | null;
            /**
             * Format: double
             * @description Height of the ground at the contact centre, mm, along its normal from where flat ground touches the inflated tire.
             */
            depth_mm: number;
            /** @description P1, P2, ... in order. */
            locations: components["schemas"]["LocationStrain"][];
            /** @description Crown, shoulder and sidewall above the contact centre. */
            section: components["schemas"]["Section"];
            /** @description The inflated state before contact. */
            inflated: components["schemas"]["Inflated"];
            /** @description Estimated discretisation errors of the readout. */
            error: components["schemas"]["ResponseError"];
            /**
             * Format: double
             * @description Largest |J - 1| of an element's mean.
             */
            max_volume_change: number;
            /** @description Newton iterations of all load steps of this solve. */
            newton_iterations: number;
            /** @description Residual norms relative to the forces of the problem, one list per load step. */
            residual_history: number[][];
            /** @description Model that was solved. */
            model: components["schemas"]["ModelSummary"];
            /** @description Readings, one per gauge asked for, in the order asked. */
            gauges?: components["schemas"]["GaugeReading"][];
            carcass?: components["schemas"]["CarcassState"] | null;
            film?: components["schemas"]["FilmState"] | null;
            /** @description Derivatives by the numbers asked for, in the order asked. */
            derivatives?: components["schemas"]["Derivative"][];
        };
        /** @description Estimated errors: absolute, of the largest reported value of each kind. */
        ResponseError: components["schemas"]["StrainFields_f64"] & {
            /**
             * Format: double
             * @description Contact penetration's share of the reaction, N.
             */
            reaction_n: number;
        };
        /** @description Left-out runs that are zeroed after lifting. */
        RestedReport: {
            /**
             * Format: double
             * @description Rest between lifting and zero, s.
             */
            rest_s: number;
            /** @description Number of liftings that were followed by such a rest. */
            liftings: number;
            /**
             * Format: double
             * @description N
             */
            rmse_n: number;
            /**
             * Format: double
             * @description RMSE of the same rows of the runs as recorded, N.
             */
            recorded_rmse_n: number;
        };
        /** @description Assumptions that the figures of the layout that answers rest on most, in words. */
        RestsOn: {
            /** @description The figures as assumed, and with each of the three changes that move them most; whole sentences. */
            sentence: string;
            /** @description The one that moves them most in few characters, as in `pressure: 2.31 N`, and what would answer with a change in this one's place; empty where none moves a figure by a tenth. */
            brief: string;
        };
        /** @description A load of layouts. */
        RingLoad: {
            /**
             * Format: double
             * @description Height of the ground above the inflated outer radius, mm.
             */
            depth_mm: number;
            /**
             * Format: double
             * @description Vertical force, N; null where it isn't known.
             */
            load_n?: number | null;
        };
        /** @description Rings around the whole wheel. */
        Rings: {
            /** @description Unit of the lists named `strain` and, by the depth, `slope`: `strain`, or `V` where layouts are of glued films. */
            unit: string;
            /** @description A ring for each section angle that layouts have; none where the study asks for no layouts. */
            rings: components["schemas"]["WheelRing"][];
        };
        /** @description A way to answer the study, and what it gave. */
        Rung: {
            /** @description Label in a few words. */
            label: string;
            /** @description Mesh and method. */
            fidelity: components["schemas"]["FidelityReport"];
            /**
             * Format: double
             * @description Wall-clock time, s.
             */
            wall_s: number;
            /**
             * Format: double
             * @description Processor time, s.
             */
            cpu_s: number;
            /** @description Solves, those on the coarser mesh included. */
            solves: number;
            /**
             * Format: double
             * @description Largest error of an index that the ranking goes by, absolute; null where an index is missing.
             */
            error_true?: number | null;
            /**
             * Format: double
             * @description The largest that the rung claims.
             */
            error_claimed?: number | null;
            /**
             * Format: double
             * @description Share of the indices whose claimed error covers the true one; null where nothing is claimed.
             */
            covered?: number | null;
            /** @description Whether the locations rank as by the reference, where that one's own errors leave no doubt which of two is better. */
            ranking_agrees: boolean;
            /** @description Whether no other rung is both faster and nearer to the reference. */
            pareto: boolean;
            /** @description Indices of the locations, in the order of their names. */
            indices: components["schemas"]["Index"][];
        };
        /** @description A scene to be solved once, and what is read of it. */
        SceneQuestionDocument: {
            /** @description The scene: its tables, or a shipped one with changes, as `{"preset": "foot-tire"}`. */
            scene: components["schemas"]["ChangedSceneDocument"] | string;
            /** @description Points of the inner surface where the strain is read, each along a direction. */
            gauges?: components["schemas"]["GaugeDocument"][];
            /** @description Numbers of the scene by which the answer is differentiated, by path, as `ground.depths_mm[2]`. */
            derivatives?: string[];
        };
        /** @description Layouts with their scores. */
        ScoredLayouts: {
            /** @description Layouts in the order of the request. */
            layouts: components["schemas"]["RankedLayout"][];
        };
        /** @description Strains over the section above the contact centre. */
        Section: {
            /** @description 0 degrees from the crown. */
            crown: components["schemas"]["StrainFields_f64"];
            /** @description 45 degrees from the crown. */
            shoulder: components["schemas"]["StrainFields_f64"];
            /** @description 90 degrees from the crown. */
            sidewall: components["schemas"]["StrainFields_f64"];
        };
        /** @description A solved node. */
        SectionNode: {
            /**
             * Format: double
             * @description Value of the input.
             */
            value: number;
            /** @description Place among the study's points. */
            ordinal: number;
            /** @description Whether it is the cut point, where the input is at its mean, too. */
            cut_point: boolean;
            /**
             * Format: double
             * @description Vertical force, N.
             */
            reaction_n: number;
            /** @description Circumferential strain, rows x columns. */
            strain_x: number[];
            /** @description Meridional strain, rows x columns. */
            strain_y: number[];
            /** @description Displacements from `inflated_mm` to the node's equilibrium, mm, rows x columns: also where the input changes the inflated state. */
            displacement_mm: number[][];
        };
        /** @description Strains and displacements over the map along the line of one input; all others are at their means. */
        Sections: {
            /** @description Name of the input. */
            input: string;
            /** @description Path of the scene's field. */
            vary: string;
            /** @description Angles of the columns from the contact centre, degrees. */
            theta_deg: number[];
            /** @description Angles of the rows from the crown, degrees. */
            phi_deg: number[];
            /** @description Places of the map's points in the inflated state at the means, mm, rows x columns. */
            inflated_mm: number[][];
            /** @description The solved nodes, by value. A design of scattered points has the means alone. */
            nodes: components["schemas"]["SectionNode"][];
            /** @description Nodes that have no equilibrium, by value. */
            failed: components["schemas"]["FailedNode"][];
        };
        /** @description Claimed errors of bounds with four unknowns, each in the unit of its bound. */
        ShearError: {
            /**
             * Format: double
             * @description Error of the bound of the angle, degrees.
             */
            worst_angle_error_deg?: number | null;
            /** @description Errors of the bounds of the forces, N. */
            worst_force_error_n?: (number | null)[] | null;
        };
        /**
         * @description Cramer-Rao bounds with four unknowns: contact angle, depth, and the ground's shifts along the wheel and across it, about a contact that isn't dragged. A
         *     shift across that no film feels doesn't enter.
         */
        ShearScore: {
            /**
             * Format: double
             * @description Bound of the contact angle, worst angle, degrees.
             */
            worst_angle_error_deg?: number | null;
            /** @description Bounds of the ground's forces on the tire along the wheel, across it (null where no film feels it) and up, worst angle, N. */
            worst_force_error_n?: (number | null)[] | null;
            error?: components["schemas"]["ShearError"] | null;
            /** @description Quantity that can't be told, in words. */
            reason?: string | null;
        };
        /** @description A film of the answer, and where it is glued on the tire that isn't inflated. */
        SheetFilm: {
            /** @description Number of the film, from 1, around the wheel from the mark. */
            number: number;
            /**
             * Format: double
             * @description Wheel angle from the mark in the rolling direction, degrees.
             */
            theta_deg: number;
            /**
             * Format: double
             * @description Arc on the inner surface from the mark to the film's middle, around the wheel at its section angle, mm.
             */
            arc_mm: number;
            /**
             * Format: double
             * @description Arc once around the wheel there, mm.
             */
            circle_mm: number;
            /**
             * Format: double
             * @description Section angle from the crown, degrees.
             */
            phi_deg: number;
            /**
             * Format: double
             * @description Arc on the inner surface from the nearer bead, where the wall ends, to the film's middle, mm.
             */
            from_bead_mm: number;
            /**
             * Format: double
             * @description Arc from the crown to the film's middle, negative on the side of negative section angles, mm.
             */
            from_crown_mm: number;
            /** @description Direction of its length: `x`, `y`, or an angle such as `45`. */
            direction: string;
            /**
             * Format: double
             * @description Length of the film, mm; null of a point.
             */
            length_mm?: number | null;
            /**
             * Format: double
             * @description Width of the film, mm; null of a point.
             */
            width_mm?: number | null;
            /**
             * Format: double
             * @description Arc from the mark to its connector, which is at the end nearer to a bead, and of a film along the wheel at the end ahead, mm.
             */
            connector_arc_mm?: number | null;
            /**
             * Format: double
             * @description Arc from the nearer bead to its connector, mm.
             */
            connector_from_bead_mm?: number | null;
            /**
             * Format: double
             * @description Length of a lead from its connector straight to the bead, and along that to the mark on the shorter way, mm.
             */
            lead_mm?: number | null;
            /**
             * Format: double
             * @description Strain that it reads with the contact at it, at the depth below; null of glued films, and where it isn't known.
             */
            expected_strain?: number | null;
            /**
             * Format: double
             * @description Open circuit's voltage that a glued film reads so, V; null of bare films.
             */
            expected_v?: number | null;
            /**
             * Format: double
             * @description Depth of that contact: the load in the middle, mm.
             */
            expected_depth_mm?: number | null;
        };
        /**
         * @description Quantity that changes along a curve.
         * @enum {string}
         */
        SignalAxis: "load" | "pressure" | "contact";
        /** @description The open circuit's voltage of one film over loads, pressures or contact angles. */
        SignalCurve: {
            /** @description Name of the tire. */
            tire: string;
            /** @description Model of the film. */
            film: components["schemas"]["FilmModel"];
            /** @description Position of the film in the section. */
            position: string;
            /** @description Direction of its length. */
            direction: string;
            /** @description Quantity that changes along it. */
            over: components["schemas"]["SignalAxis"];
            /**
             * Format: double
             * @description Slope of the line of least squares, V per N, per MPa or per degree; null of fewer than two points.
             */
            slope?: number | null;
            monotone?: components["schemas"]["Trend"] | null;
            /** @description Whether every step is larger than the errors of its two ends together. */
            monotone_certain: boolean;
            /**
             * Format: double
             * @description Share of the variance that the line explains; null of fewer than three points, and where nothing varies.
             */
            linear_r2?: number | null;
        };
        /** @description Errors of a film's reading by the mesh, absolute: the change from the next coarser mesh, times Richardson's factor. */
        SignalError: {
            /**
             * Format: double
             * @description Error of the strain.
             */
            strain: number;
            /**
             * Format: double
             * @description Error of the charge, nC.
             */
            charge_nc: number;
            /**
             * Format: double
             * @description Error of the open circuit's voltage, V.
             */
            open_circuit_v: number;
            /**
             * Format: double
             * @description Error of the amplifier's voltage, V.
             */
            output_v: number;
        };
        /** @description Reading of one film at one pressing. */
        SignalRow: {
            /** @description Name of the tire; the study's own is `own`. */
            tire: string;
            /** @description Model of the film. */
            film: components["schemas"]["FilmModel"];
            /** @description Position of the film in the section. */
            position: string;
            /** @description Direction of its length: x circumferential, y meridional. */
            direction: string;
            /** @description Curve that it is a point of. */
            over: components["schemas"]["SignalAxis"];
            /**
             * Format: double
             * @description Vertical force of the ground, N.
             */
            load_n: number;
            /**
             * Format: double
             * @description Internal pressure, MPa.
             */
            pressure_mpa: number;
            /**
             * Format: double
             * @description Wheel angle from the film to the contact, degrees.
             */
            contact_deg: number;
            /**
             * Format: double
             * @description Height of the ground above the inflated outer radius, mm.
             */
            depth_mm?: number | null;
            /**
             * Format: double
             * @description Mean strain along the film since inflation.
             */
            strain?: number | null;
            /**
             * Format: double
             * @description Mean tension along the film since inflation, N/mm.
             */
            tension_1_n_per_mm?: number | null;
            /**
             * Format: double
             * @description Charge, nC.
             */
            charge_nc?: number | null;
            /**
             * Format: double
             * @description Voltage where nothing draws charge, V.
             */
            open_circuit_v?: number | null;
            /**
             * Format: double
             * @description Amplitude at the amplifier, V.
             */
            output_v?: number | null;
            /**
             * Format: double
             * @description Standard deviation of that by noise, gain and temperature, V.
             */
            output_std_v?: number | null;
            /** @description Whether the film bears that, and the amplifier shows it: `ok`, `beyond-yield`, `saturated` or `wrinkled`; null where that isn't known. */
            state?: string | null;
            error?: components["schemas"]["SignalError"] | null;
            /** @description Reason why numbers are null. */
            reason?: string | null;
        };
        /** @description Films' signals over load, pressure and contact angle. */
        Signals: {
            /** @description Readings of each film at each pressing. */
            rows: components["schemas"]["SignalRow"][];
            /** @description The rows as curves of the open circuit's voltage. */
            curves: components["schemas"]["SignalCurve"][];
            /** @description Two films around the wheel, read against each other. */
            pairs: components["schemas"]["FilmPair"][];
            /** @description Widths around the wheel over which the contact is felt. */
            widths: components["schemas"]["StressWidth"][];
            /** @description Claims about such films, and what holds of them. */
            claims: components["schemas"]["ClaimRow"][];
        };
        /** @description The film that gives most, at the largest load on the study's own tire. */
        SignalsAnswer: {
            /** @description The film in a sentence, with the next. */
            sentence: string;
            /** @description Certainty that none of those read gives more. */
            verdict: components["schemas"]["Certainty"];
            /** @description Reason for the verdict, with the figures that decide. */
            reason: string;
            /** @description Model of the film: the most detailed of those that are read. */
            film: components["schemas"]["FilmModel"];
            /** @description Position of the film in the section. */
            position: string;
            /** @description Direction of its length: `x` or `y`. */
            direction: string;
            /**
             * Format: double
             * @description Vertical force of the ground, N.
             */
            load_n: number;
            /**
             * Format: double
             * @description Voltage where nothing draws charge, V.
             */
            open_circuit_v: number;
            /**
             * Format: double
             * @description Claimed error of that, V; null without a coarser mesh.
             */
            error_v?: number | null;
        };
        /** @description Equilibria that are expected to be solved. */
        SolveForecast: {
            /** @description Points on the meshes of the answer and of the rungs before it. */
            own: number;
            /** @description Points solved once more on coarser meshes, for the error of the mesh. */
            coarser: number;
            /** @description Solves that show what the model leaves out. */
            effects: number;
            /** @description Solves of films' signals, on both meshes. */
            signals: number;
            /** @description Solves of layouts' loads, on both meshes. */
            layouts: number;
            /** @description Solves of a rig's table of responses. */
            tables: number;
            /** @description Solves among these that the database has already: they cost nothing. */
            known: number;
            /** @description Solves that are left. */
            left: components["schemas"]["CountForecast"];
        };
        /** @description Progress of a solve. */
        SolveProgress: {
            /** @description Stage of the loads. */
            stage: components["schemas"]["Stage"];
            /**
             * Format: double
             * @description Share of the stage's loads at which it has been in equilibrium, 0 to 1.
             */
            share: number;
            /** @description Newton iterations so far. */
            iterations: number;
            /**
             * Format: double
             * @description Residual at which the newest one began: out-of-balance forces and volumes, relative to the tire's own; null where it has none. An equilibrium has 1e-8.
             */
            residual?: number | null;
        };
        /**
         * @description Equilibrium of a scene.
         *
         *     Strains are stretches relative to the inflated state minus one, on the inner surface; x circumferential, y meridional.
         */
        SolvedScene: components["schemas"]["Response"] & {
            /** @description Status: `converged`. */
            status: string;
            /**
             * Format: double
             * @description Time of the solve, s.
             */
            wall_s: number;
            /** @description Values that are unlikely in the scene or at its film's amplifier, whole sentences. */
            unlikely: string[];
        };
        /** @description The chosen model on rows that were left out by one split. */
        SplitError: {
            /** @description The split: `random` readings of the begin of one run, whose neighbours are learnt from; later `time`; whole `run`s or `cycle`s. */
            by: components["schemas"]["SplitKind"];
            /**
             * Format: double
             * @description Root of the mean squared error, N.
             */
            rmse_n?: number | null;
            /** @description 95 % of the bootstrap's samples of whole cycles, N. */
            rmse_interval_n?: number[] | null;
            /**
             * Format: double
             * @description RMSE over the range of the tested forces, %.
             */
            nrmse_percent?: number | null;
            /**
             * Format: double
             * @description NRMSE of the training mean, %.
             */
            mean_nrmse_percent?: number | null;
            /**
             * Format: double
             * @description Coefficient of determination.
             */
            r2?: number | null;
            /**
             * Format: double
             * @description Share of tested rows within their 95 % intervals, whose width was learnt from other groups.
             */
            coverage?: number | null;
            /**
             * Format: double
             * @description Mean width of these intervals, N.
             */
            width_n?: number | null;
            /** @description Reason why numbers are null. */
            reason?: string | null;
        };
        /**
         * @description Split of the rows into those that are learnt from and those that are tested.
         * @enum {string}
         */
        SplitKind: "random" | "cycle" | "run" | "time" | "frequency";
        /** @description A candidate on one split. */
        SplitReport: {
            /** @description The split. */
            by: components["schemas"]["SplitKind"];
            /**
             * Format: double
             * @description Root of the mean squared error, N.
             */
            rmse_n: number;
            /**
             * Format: double
             * @description RMSE of the tested rows that aren't suspect, which chooses, N; left out where none is suspect.
             */
            sound_rmse_n?: number | null;
            /** @description 95 % of the bootstrap's samples of whole cycles, N. */
            rmse_interval_n?: number[] | null;
            /**
             * Format: double
             * @description RMSE over the range of the tested forces, %.
             */
            nrmse_percent?: number | null;
            /**
             * Format: double
             * @description NRMSE of the training mean, %.
             */
            mean_nrmse_percent?: number | null;
            /**
             * Format: double
             * @description Coefficient of determination.
             */
            r2?: number | null;
            /**
             * Format: double
             * @description Share of tested rows within their 95 % intervals, whose width was learnt from other groups.
             */
            coverage?: number | null;
            /**
             * Format: double
             * @description Mean width of these intervals, N.
             */
            width_n?: number | null;
        };
        /** @description A candidate on every split. */
        SplitReports: {
            random?: components["schemas"]["SplitReport"] | null;
            cycle?: components["schemas"]["SplitReport"] | null;
            run?: components["schemas"]["SplitReport"] | null;
            time?: components["schemas"]["SplitReport"] | null;
            frequency?: components["schemas"]["SplitReport"] | null;
        };
        /**
         * @description Stage of the loads on a tire.
         * @enum {string}
         */
        Stage: "inflating" | "pressing";
        /**
         * @description State of a study.
         * @enum {string}
         */
        State: "queued" | "running" | "done" | "failed" | "cancelled";
        /** @description Names of strains and their errors. */
        StrainFields_f64: {
            /** Format: double */
            strain_x: number;
            /** Format: double */
            strain_y: number;
        };
        /** @description Signals around the wheel at one load, of one kind of film: strains, or volts of glued films. */
        StrainRing: {
            /**
             * Format: double
             * @description Section angle from the crown, degrees.
             */
            section_deg: number;
            /** @description Direction. */
            direction: string;
            /**
             * Format: double
             * @description Depth of the load, mm.
             */
            depth_mm: number;
            /** @description Strains from -180 to 179 degrees from the contact. */
            strain: number[];
            /** @description Derivative by the depth, 1/mm. */
            by_depth: number[];
            /**
             * Format: double
             * @description Largest error of the signal by the coarser mesh.
             */
            strain_error?: number | null;
            /**
             * Format: double
             * @description Largest error of the derivative by the coarser mesh, 1/mm.
             */
            by_depth_error?: number | null;
        };
        /** @description An event of a stream. */
        StreamEvent: {
            /** @description Number of the event, for `Last-Event-ID`; `solving` has none. */
            id: string;
            /** @description Kind of event. */
            event: string;
            /** @description A JSON object with `kind`, `time` and what else belongs to it. */
            data: string;
        };
        /** @description A Gaussian in the von Mises stress of the inner surface around the wheel at the crown: offset + amplitude exp(-angle^2 / (2 width^2)). */
        StressWidth: {
            /** @description Name of the tire. */
            tire: string;
            /**
             * Format: double
             * @description Vertical force of the ground, N.
             */
            load_n: number;
            /**
             * Format: double
             * @description Height of the ground above the inflated outer radius, mm.
             */
            depth_mm?: number | null;
            /**
             * Format: double
             * @description Amplitude, MPa.
             */
            amplitude_mpa?: number | null;
            /**
             * Format: double
             * @description Standard deviation, degrees around the wheel.
             */
            width_deg?: number | null;
            /**
             * Format: double
             * @description Stress far from the contact, MPa.
             */
            offset_mpa?: number | null;
            /**
             * Format: double
             * @description Share of the variance within 60 degrees of the contact that the Gaussian explains.
             */
            r2?: number | null;
            /** @description Reason why numbers are null. */
            reason?: string | null;
        };
        /** @description Names of a film's stretches. */
        StretchFields_Extremes: {
            /** @description Least and greatest value of a field. */
            stretch_x: {
                /**
                 * Format: double
                 * @description Least value.
                 */
                min: number;
                /**
                 * Format: double
                 * @description Greatest value.
                 */
                max: number;
            };
            /** @description Least and greatest value of a field. */
            stretch_y: {
                /**
                 * Format: double
                 * @description Least value.
                 */
                min: number;
                /**
                 * Format: double
                 * @description Greatest value.
                 */
                max: number;
            };
        };
        /** @description Cost of a study. */
        StudyCost: {
            /** @description Points of the plan. */
            solves: number;
            /** @description Points of the plan solved once more on a coarser mesh, for the error of the mesh. */
            coarser_solves: number;
            /** @description Solves that show what the model leaves out. */
            effect_solves: number;
            /** @description Solves of films' signals, on both meshes. */
            signal_solves: number;
            /** @description Solves of layouts' loads, on both meshes. */
            layout_solves: number;
            /** @description Solves of a rig's table of responses. */
            table_solves: number;
            /** @description Wall-clock time of each rung of the climb, s. */
            rungs_wall_s?: number[];
            /** @description Points taken from the archive instead of being solved. */
            reused: number;
            /** @description Newton iterations of all solves. */
            newton_iterations: number;
            /** @description Factorisations of all solves, without the tangent that the solves from one equilibrium share. */
            factorisations: number;
            /**
             * Format: double
             * @description Wall-clock time of this run, s.
             */
            wall_s: number;
            /**
             * Format: double
             * @description Processor time of this run's own threads, s; 0 where the system doesn't tell it.
             */
            cpu_s: number;
            /**
             * Format: int64
             * @description Peak memory of the process, bytes.
             */
            peak_memory_bytes: number;
            /**
             * Format: double
             * @description Share of the solves' time in numeric factorisation.
             */
            factorisation_share: number;
            /**
             * Format: double
             * @description Share in substitutions with the factor, and in the contact solved between them.
             */
            substitution_share: number;
            /**
             * Format: double
             * @description Share in assembly.
             */
            assembly_share: number;
            /**
             * Format: double
             * @description Share in all the rest, and in solves that found no equilibrium.
             */
            other_share: number;
        };
        /** @description A study with its document and what was expected of it. */
        StudyDetail: components["schemas"]["StudySummary"] & {
            /** @description The canonical document: every default filled in, the scene inline. */
            document: Record<string, unknown>;
            estimate?: components["schemas"]["Estimate"] | null;
            /** @description Hash of the result's content; null before there is one. The result's ETag. */
            result_sha256?: string | null;
            /** @description Whether what accuracy costs was measured for this document. */
            trade_measured: boolean;
            /** @description Identifier of the sweep that it is a design of; null for any other study. */
            sweep?: string | null;
        };
        /** @description Study: what varies, and what is asked. */
        StudyDocument: {
            /** @description Free text. */
            name: string;
            /** @description Scene: tables, a preset's name with whatever differs from it, or a path. */
            scene: components["schemas"]["ChangedSceneDocument"] | string;
            /** @description Inputs that vary. */
            inputs: components["schemas"]["InputDocument"][];
            /** @description Candidate places for films. */
            candidates?: components["schemas"]["CandidatesDocument"];
            /** @description Layouts to score; none when left out. */
            layouts?: components["schemas"]["LayoutsDocument"];
            /** @description Question that the layouts answer: the best with so many films, or the fewest that keep errors within limits; none when left out. */
            question?: components["schemas"]["QuestionDocument"];
            /** @description Method that computes the indices. */
            method?: components["schemas"]["MethodDocument"];
            /** @description Accuracy that is asked of the answer: exactly one of the three. */
            accuracy?: components["schemas"]["AccuracyDocument"];
            /** @description Films' signals over loads, pressures and contact angles; none when left out. */
            signals?: components["schemas"]["SignalsDocument"];
            /** @description A virtual rig that steps on the tire; none when left out. */
            rig?: components["schemas"]["RigDocument"];
        };
        /** @description Identity of a study: which document, which program. */
        StudyIdentity: {
            /** @description Identifier in the database. */
            id: string;
            /** @description Name from the document. */
            name: string;
            /** @description SHA-256 of the canonical document. */
            spec_sha256: string;
            /** @description Version of strainsite and its solver. */
            version: string;
        };
        /** @description A page of studies, newest first. */
        StudyPage: {
            /** @description The studies. */
            studies: components["schemas"]["StudySummary"][];
            /** @description Cursor of the next page; null on the last one. */
            next_cursor?: string | null;
        };
        /** @description The whole answer. */
        StudyResult: {
            /** @description Identity of the study. */
            study: components["schemas"]["StudyIdentity"];
            answer?: components["schemas"]["Answer"] | null;
            /** @description Model that was solved. */
            model: components["schemas"]["ModelSummary"];
            /** @description Inputs that varied. */
            inputs: components["schemas"]["InputReport"][];
            /** @description Every location and direction with its indices. */
            outputs: components["schemas"]["Output"][];
            /** @description Ranked locations. */
            locations: components["schemas"]["RankedLocation"][];
            /** @description Ranked layouts. */
            layouts: components["schemas"]["RankedLayout"][];
            layout_findings?: components["schemas"]["LayoutFindings"] | null;
            map?: components["schemas"]["IndexMap"] | null;
            signals?: components["schemas"]["Signals"] | null;
            forces?: components["schemas"]["ForceFindings"] | null;
            /** @description Notes that the user must know before believing the numbers, whole sentences: the texts of `graded_notes`. */
            notes: string[];
            /** @description Notes with what each does to the answer. */
            graded_notes: components["schemas"]["GradedNote"][];
            /** @description Points that have no equilibrium, with their causes; the indices are taken from the others. */
            failed_points: components["schemas"]["FailedPoint"][];
            /** @description The cut point's own response in short: reaction and strains at the means. */
            cut_point: components["schemas"]["CutPoint"];
            climb?: components["schemas"]["Climb"] | null;
            /** @description Cost of the study. Not part of the result's hash. */
            cost: components["schemas"]["StudyCost"];
            estimate?: components["schemas"]["Estimate"] | null;
        };
        /** @description A study in the queue, at work, or at its end. Times are RFC 3339, UTC. */
        StudySummary: {
            /** @description UUID, ordered by time. */
            id: string;
            /** @description Name in lists: the document's, unless it was changed since. */
            name: string;
            /** @description State of the study. */
            state: components["schemas"]["State"];
            /** @description SHA-256 of the canonical document. */
            spec_sha256: string;
            /**
             * Format: int64
             * @description Points of its plan, as far as that is known.
             */
            points_total?: number | null;
            /**
             * Format: int64
             * @description Points that have an outcome.
             */
            points_done: number;
            /** @description Reason why it failed, a sentence. */
            error?: string | null;
            /**
             * Format: int64
             * @description Priority: studies of higher ones go first, those of the same in turns.
             */
            priority: number;
            /** @description Time at which it was submitted. */
            created: string;
            /** @description Time at which it was first started. */
            started?: string | null;
            /** @description Time at which it ended. */
            finished?: string | null;
            /** @description Time at which it was archived; null unless it is. */
            archived?: string | null;
            /** @description The answer in few characters, as in `12 y films, 10.7 degrees`; null before there is one. */
            brief?: string | null;
        };
        /** @description Price of a surer answer. */
        Surer: {
            /** @description Sentence that says what the next level would do, and how long it would take. */
            sentence: string;
            /** @description Mesh level to ask for. */
            level: string;
            /**
             * Format: double
             * @description Work over that of this study with nothing solved before, by the law of solve times; null of solvers without one.
             */
            times?: number | null;
            /**
             * Format: double
             * @description Expected wall-clock time with what the database has, s; null where it can't be told.
             */
            expected_s?: number | null;
        };
        /** @description A sweep with its designs. */
        SweepDetail: components["schemas"]["SweepSummary"] & {
            /** @description The canonical document of the study without changes. */
            document: Record<string, unknown>;
            /** @description The designs in order, as many as were asked for; `counts` has them all. */
            designs: components["schemas"]["DesignView"][];
        };
        /** @description A study, and what its designs set otherwise: `grid` or `designs`. */
        SweepDocument: {
            /** @description Free text; the study's name when left out. */
            name?: string;
            /** @description The study without changes. */
            study: components["schemas"]["StudyDocument"];
            /** @description Lists of values by path, as `geometry.wall_mm`: every combination is a design, the last path varying fastest. */
            grid?: {
                [key: string]: unknown[];
            };
            /** @description Designs, one by one. */
            designs?: components["schemas"]["DesignDocument"][];
        } & unknown;
        /** @description Estimate of a sweep's cost. */
        SweepEstimate: {
            /** @description Each design; what an earlier one solves is known to it. */
            designs: components["schemas"]["DesignEstimate"][];
            /** @description Solves left of all designs. */
            left: components["schemas"]["CountForecast"];
            wall_s?: components["schemas"]["Forecast"] | null;
            /**
             * Format: int64
             * @description Largest memory of any design, bytes.
             */
            peak_memory_bytes: number;
            /**
             * Format: int64
             * @description Room that all designs take in the database, bytes.
             */
            database_bytes: number;
        };
        /** @description A page of sweeps, newest first. */
        SweepPage: {
            /** @description The sweeps. */
            sweeps: components["schemas"]["SweepSummary"][];
            /** @description Cursor of the next page; null on the last one. */
            next_cursor?: string | null;
        };
        /** @description A sweep as far as it is. Times are RFC 3339, UTC. */
        SweepSummary: {
            /** @description UUID, ordered by time. */
            id: string;
            /** @description Name in lists: as it was submitted, unless it was changed since. */
            name: string;
            /** @description `queued` before any design is begun, `running` while some aren't ended, `cancelled` when any was, `done` when any has a result. */
            state: components["schemas"]["State"];
            /** @description Designs by where they stand. */
            counts: components["schemas"]["DesignCounts"];
            /**
             * Format: int64
             * @description Points of all designs, once all of their plans are known.
             */
            points_total?: number | null;
            /**
             * Format: int64
             * @description Points that have an outcome.
             */
            points_done: number;
            /**
             * Format: int64
             * @description Priority of its studies.
             */
            priority: number;
            /** @description Time at which it was submitted. */
            created: string;
            /** @description Time at which its last design ended. */
            finished?: string | null;
            /** @description Time at which it was archived; null unless it is. */
            archived?: string | null;
            /**
             * Format: double
             * @description Time in which any of its designs was at work so far, s.
             */
            worked_s: number;
        };
        /**
         * @description Table of a study.
         * @enum {string}
         */
        Table: "indices" | "locations" | "layouts" | "trade" | "films" | "points" | "signals" | "candidates" | "forces";
        /** @description Errors of a table over all kinds of film, wheel angles and tested solves, relative. */
        TableError: {
            /** @description Solves that it was tested by. */
            solves: number;
            /**
             * Format: double
             * @description Root mean square of a signal's error, over the largest signal of its kind.
             */
            signal_rms: number;
            /**
             * Format: double
             * @description The largest.
             */
            signal_worst: number;
            /**
             * Format: double
             * @description Root mean square of the error of a slope over the wheel angle, over the largest of its kind.
             */
            angle_slope_rms: number;
            /**
             * Format: double
             * @description The largest.
             */
            angle_slope_worst: number;
            /**
             * Format: double
             * @description Root mean square of the error of a slope over the depth, over the largest of its kind.
             */
            depth_slope_rms: number;
            /**
             * Format: double
             * @description The largest.
             */
            depth_slope_worst: number;
            /**
             * Format: double
             * @description The largest error of a force's component, over the largest load.
             */
            force_worst: number;
        };
        /** @description A table of a tire's responses to any contact. */
        TableReport: {
            /** @description Mesh level. */
            level: string;
            /**
             * Format: double
             * @description The largest load, N.
             */
            largest_load_n: number;
            /**
             * Format: double
             * @description The largest shift of the ground at that load, along the wheel and across, mm; 0 where there is no friction.
             */
            largest_shift_mm: number;
            /** @description Solves, those that test it included. */
            solves: number;
            error?: components["schemas"]["TableError"] | null;
            films?: components["schemas"]["FilmAnglesReport"] | null;
        };
        /**
         * @description Part of a recording that a column is taken for.
         * @enum {string}
         */
        Taken: "time" | "force" | "signal" | "cycle" | "nothing";
        /** @description Tasks by where they stand. */
        TaskCounts: {
            /** @description Tasks that wait for a machine. */
            waiting: number;
            /** @description Tasks that a machine does; of a command of the user's all that it hasn't handed in. */
            running: number;
            /** @description Tasks that have ended. */
            ended: number;
        };
        /** @description Report of what becomes of a sweep's tasks. */
        TaskReport: {
            /** @description Tasks of the round. */
            tasks: components["schemas"]["TaskCounts"];
            /** @description Reason why the first of those that wait does, in the engine's words. */
            because?: string | null;
            /** @description Designs of the round. */
            designs: number;
            /** @description Designs of the round whose task was taken in and that have ended. */
            designs_ended: number;
            /** @description Nodes that handed in nothing, and why. */
            refused: components["schemas"]["Refusal"][];
            /** @description Further words about it, the latest last. */
            said: string[];
        };
        /** @description Names of a film's tensions. */
        TensionFields_Extremes: {
            /** @description Least and greatest value of a field. */
            tension_x_n_per_mm: {
                /**
                 * Format: double
                 * @description Least value.
                 */
                min: number;
                /**
                 * Format: double
                 * @description Greatest value.
                 */
                max: number;
            };
            /** @description Least and greatest value of a field. */
            tension_y_n_per_mm: {
                /**
                 * Format: double
                 * @description Least value.
                 */
                min: number;
                /**
                 * Format: double
                 * @description Greatest value.
                 */
                max: number;
            };
        };
        /** @description Error of what films tell of a quantity that contacts differ in. */
        ToldQuantity: {
            /** @description The quantity, as `layouts.contacts` names it, or a load in the wheel's frame: `fx_n`, `fy_n`, `mx_nmm`, `my_nmm`, `mz_nmm`. */
            of: string;
            /** @description Name for people. */
            words: string;
            /**
             * Format: double
             * @description Error of its estimate, root mean square over contacts, in its own unit.
             */
            error: number;
            /**
             * Format: double
             * @description Standard error of it by the number of simulated contacts; none of a study before it was told, nor are the next two.
             */
            error_se?: number | null;
            /**
             * Format: double
             * @description Claimed error of it, by that and the coarser mesh.
             */
            claim?: number | null;
            /**
             * Format: double
             * @description Load at which it is this large, N: the worst one.
             */
            load_n?: number | null;
            /**
             * Format: double
             * @description Standard deviation over contacts: the error where films tell nothing.
             */
            deviation: number;
            /** @description Whether films tell something of it: the error is at least a tenth less than the deviation. */
            known: boolean;
        };
        /**
         * @description The part of a result that a note is about.
         * @enum {string}
         */
        Topic: "place" | "layout" | "map" | "indices" | "signals" | "model" | "cost";
        /** @description The measured trade of a study. */
        Trade: {
            /** @description Name of the study. */
            study: string;
            /** @description SHA-256 of its canonical document. */
            spec_sha256: string;
            /** @description Rung with which the others are compared. */
            reference: components["schemas"]["Rung"];
            /** @description The rungs, in the order of the ladder. */
            rungs: components["schemas"]["Rung"][];
        };
        /** @description Trade of films against errors: the best layout of each number of films, and which of them answers the question. */
        TradeAnswer: {
            /** @description Question of the document; empty where none is asked. */
            question: components["schemas"]["Question"];
            /** @description Best layout of each number of films, fewest first: that with the least error of the angle, or the one that comes closest to the limits asked for. */
            rows: components["schemas"]["TradeRow"][];
            /** @description Row that answers, from 0: the question's, or the knee where none is asked; null where no layout meets the question. */
            picked?: number | null;
            /** @description Knee, a row from 0: from there on twice the films don't halve the error; null where every layout loses the contact. */
            knee?: number | null;
            /** @description Layouts that were tried: named in the document, found by its search, or on its menu. */
            tried: number;
            /** @description Layouts of the menu that weren't simulated, as their bounds show that others with as few films are better. */
            screened: number;
            /** @description Layouts of the menu whose films have no room. */
            without_room: number;
            /** @description Most films that the question allows, by their number and their cost; null where it has no limit. */
            most_films?: number | null;
            /** @description Sentence that says what was tried. */
            menu: string;
        };
        /** @description Best layout of a number of films. */
        TradeRow: {
            /** @description Number of films. */
            film_count: number;
            /** @description Rank of the layout in `layouts`. */
            rank: number;
            /** @description Index of the layout in the list of layouts, from 0: mirror images share a rank. */
            index: number;
            /** @description Description of the layout, as in `12 films along y at the crown, one every 30 degrees`. */
            words: string;
            /**
             * Format: double
             * @description Simulated 95th percentile of the angle's error at its worst load, degrees.
             */
            angle_error_deg: number;
            /**
             * Format: double
             * @description Claimed error of that, degrees; null where there is no coarser mesh.
             */
            angle_claim_deg?: number | null;
            /**
             * Format: double
             * @description Root mean square error of the vertical force at the load where that is largest, N.
             */
            force_error_n?: number | null;
            /**
             * Format: double
             * @description Claimed error of that, N; null where there is no coarser mesh.
             */
            force_claim_n?: number | null;
            /**
             * Format: double
             * @description Cost of the films that aren't glued on already, and of a channel for each; null where the question tells no costs.
             */
            cost?: number | null;
            /** @description Whether it meets every limit that is asked for; null where none is. */
            meets?: boolean | null;
            /** @description Whether fewer films do worse. */
            is_front: boolean;
        };
        /**
         * @description Trend of a curve.
         * @enum {string}
         */
        Trend: "up" | "down" | "no";
        /** @description Estimates against true forces on runs that nobody learnt from, rows in the air among them. */
        TrialError: {
            /**
             * Format: double
             * @description Root of the mean squared error, N.
             */
            rmse_n?: number | null;
            /**
             * Format: double
             * @description RMSE over the range of the true forces, %; null where these don't vary.
             */
            nrmse_percent?: number | null;
            /**
             * Format: double
             * @description Coefficient of determination; null where the true forces don't vary.
             */
            r2?: number | null;
            /**
             * Format: double
             * @description Share of the true forces within their 95 % intervals.
             */
            coverage?: number | null;
            /**
             * Format: double
             * @description Share of the rows that are flagged: one of their signals is beyond what was learnt from.
             */
            outside?: number | null;
        };
        /**
         * @description Verdict on a difference.
         * @enum {string}
         */
        Verdict: "real" | "noise" | "unknown";
        /** @description Both directions around the wheel at one section angle. */
        WheelRing: {
            /**
             * Format: double
             * @description Section angle from the crown, degrees.
             */
            section_deg: number;
            load?: components["schemas"]["RingLoad"] | null;
            /** @description Angles from the contact, degrees: from -180 on. */
            theta_deg: number[];
            /** @description Circumferential strain; null where no layout has such a film. */
            strain_x?: number[] | null;
            /** @description Meridional strain; null where no layout has such a film. */
            strain_y?: number[] | null;
            /** @description Derivative of the circumferential strain by the depth, 1/mm. */
            slope_x_per_mm?: number[] | null;
            /** @description Derivative of the meridional strain by the depth, 1/mm. */
            slope_y_per_mm?: number[] | null;
        };
        /** @description Contacts about one wheel angle. */
        WorstContact: {
            /**
             * Format: double
             * @description Middle of five degrees of the wheel.
             */
            deg: number;
            /**
             * Format: double
             * @description Root of the mean squared error of rows with a contact there, N.
             */
            rmse_n: number;
        };
        /** @description Error of the vertical force at the load where it is largest. */
        WorstForce: {
            /**
             * Format: double
             * @description The error, root mean square over contacts, N.
             */
            error_n: number;
            /**
             * Format: double
             * @description Claimed error of that, N; null where there is no coarser mesh.
             */
            claim_n?: number | null;
            /**
             * Format: double
             * @description The load, N.
             */
            load_n?: number | null;
        };
        /** @description Recording without load, or nothing, which forgets an earlier zero. */
        ZeroDocument: {
            /** @description Name that faults give it. */
            file?: string | null;
            /** @description CSV: a header, then a row a line: seconds and signals; where it has forces, its rows without one count. */
            text?: string | null;
        };
        /** @description Scene: what is pressed on which ground, by how much, and how finely it is modelled. */
        ChangedSceneDocument: {
            /**
             * @description A shipped scene, over which the tables beside it are laid.
             * @enum {string}
             */
            preset?: "foot-tire" | "foot-tire-soft";
            /**
             * @description Shape of the tire.
             * @default {
             *       "kind": "tire",
             *       "outer_radius_mm": 50,
             *       "section_radius_mm": 12.5,
             *       "wall_mm": 3,
             *       "bead_angle_deg": 120
             *     }
             */
            geometry: components["schemas"]["GeometryDocument"];
            /**
             * @description Rubber.
             * @default {
             *       "model": "mooney-rivlin",
             *       "c10_mpa": 0.144,
             *       "c01_mpa": 0.036,
             *       "d1_per_mpa": 0
             *     }
             */
            material: components["schemas"]["MaterialDocument"];
            /** @description Textile layer; absent when the scene has none. */
            carcass?: components["schemas"]["CarcassDocument"] | null;
            /** @description Sensor film glued to the inner surface; absent when it isn't modelled. */
            film?: components["schemas"]["FilmDocument"] | null;
            /**
             * @description Internal pressure.
             * @default {
             *       "internal_mpa": 0.2
             *     }
             */
            pressure: components["schemas"]["PressureDocument"];
            /**
             * @description Rigid ground.
             * @default {
             *       "stations": 5,
             *       "station_spacing_mm": 5.5,
             *       "station_functions": "bspline",
             *       "depths_mm": [
             *         1,
             *         1,
             *         1,
             *         1,
             *         1
             *       ]
             *     }
             */
            ground: components["schemas"]["GroundDocument"];
            /**
             * @description Contact of tire and ground.
             * @default {
             *       "friction": 0
             *     }
             */
            contact: components["schemas"]["ContactDocument"];
            /**
             * @description Fineness of the model.
             * @default {
             *       "level": "standard"
             *     }
             */
            model: components["schemas"]["ModelDocument"];
        };
        /** @description A toroidal tire whose wall is an arc of a ring section, clamped at the beads. */
        GeometryDocument: {
            /**
             * @description Kind of body; only the tire is modelled so far. `tire`: Pneumatic tire.
             * @default tire
             * @enum {string}
             */
            kind: "tire";
            /**
             * @description Radius of the uninflated tire at the crown, mm.
             * @default 50
             */
            outer_radius_mm: number;
            /**
             * @description Outer radius of the toroidal section, mm.
             * @default 12.5
             */
            section_radius_mm: number;
            /**
             * @description Wall thickness, mm.
             * @default 3
             */
            wall_mm: number;
            /**
             * @description Angle from the crown at which the wall ends and is clamped, degrees.
             * @default 120
             */
            bead_angle_deg: number;
        };
        /** @description Rubber: an isochoric law and its compressibility. */
        MaterialDocument: {
            /**
             * @description W = c10 (I1 - 3) + c01 (I2 - 3).
             * @default mooney-rivlin
             * @constant
             */
            model: "mooney-rivlin";
            /**
             * @description First constant, MPa.
             * @default 0.144
             */
            c10_mpa: number;
            /**
             * @description Second constant, MPa.
             * @default 0.036
             */
            c01_mpa: number;
            /**
             * @description Compressibility, 1/MPa: the bulk modulus is 2/d1; 0 is exactly incompressible.
             * @default 0
             */
            d1_per_mpa: number;
        } | {
            /**
             * @description W = c10 (I1 - 3).
             * @constant
             */
            model: "neo-hookean";
            /**
             * @description Half of the shear modulus, MPa.
             * @default 0.18
             */
            c10_mpa: number;
            /**
             * @description Compressibility, 1/MPa: the bulk modulus is 2/d1; 0 is exactly incompressible.
             * @default 0
             */
            d1_per_mpa: number;
        } | {
            /**
             * @description W = c10 (I1 - 3) + c20 (I1 - 3)^2 + c30 (I1 - 3)^3.
             * @constant
             */
            model: "yeoh";
            /**
             * @description Half of the initial shear modulus, MPa.
             * @default 0.18
             */
            c10_mpa: number;
            /**
             * @description Weight of the square, MPa.
             * @default 0
             */
            c20_mpa: number;
            /**
             * @description Weight of the cube, MPa.
             * @default 0
             */
            c30_mpa: number;
            /**
             * @description Compressibility, 1/MPa: the bulk modulus is 2/d1; 0 is exactly incompressible.
             * @default 0
             */
            d1_per_mpa: number;
        } | {
            /**
             * @description W = sum of (2 mu / alpha^2) (l1^alpha + l2^alpha + l3^alpha - 3).
             * @constant
             */
            model: "ogden";
            /**
             * @description Terms; their mu add up to the initial shear modulus.
             * @default [
             *       {
             *         "mu_mpa": 0.288,
             *         "alpha": 2
             *       },
             *       {
             *         "mu_mpa": 0.072,
             *         "alpha": -2
             *       }
             *     ]
             */
            terms: components["schemas"]["OgdenTermDocument"][];
            /**
             * @description Compressibility, 1/MPa: the bulk modulus is 2/d1; 0 is exactly incompressible.
             * @default 0
             */
            d1_per_mpa: number;
        };
        /** @description A term of Ogden's law. */
        OgdenTermDocument: {
            /** @description Share of the initial shear modulus, MPa. */
            mu_mpa: number;
            /** @description Exponent. */
            alpha: number;
        };
        /** @description Textile layer: two fibre families at +-angle to the circumference, a membrane within the wall. */
        CarcassDocument: {
            /**
             * @description Angle of both families to the circumferential direction, degrees.
             * @default 55
             */
            angle_deg: number;
            /**
             * @description Stiffness of each family in tension, N/mm.
             * @default 100
             */
            stiffness_n_per_mm: number;
            /**
             * @description Position through the wall: 0 inner surface, 1 outer surface.
             * @default 0.5
             */
            position: number;
            /**
             * @description Stiffness in compression over that in tension.
             * @default 0.01
             */
            compression_ratio: number;
        };
        /** @description A rectangular film glued to the inner surface of the uninflated tire, its centre at a wheel and a section angle. */
        FilmDocument: {
            /**
             * @description Young's modulus, MPa.
             * @default 2500
             */
            modulus_mpa: number;
            /**
             * @description Poisson's ratio.
             * @default 0.34
             */
            poisson_ratio: number;
            /**
             * @description Thickness, mm.
             * @default 0.05
             */
            thickness_mm: number;
            /** @description Layers from the wall inwards, in place of the fields of one. */
            layers?: components["schemas"]["FilmLayerDocument"][];
            /**
             * @description Extent along its first axis, mm.
             * @default 5
             */
            length_mm: number;
            /**
             * @description Extent across, mm.
             * @default 5
             */
            width_mm: number;
            /**
             * @description Wheel angle of its centre from the contact centre, degrees, positive in the rolling direction.
             * @default 0
             */
            theta_deg: number;
            /**
             * @description Section angle of its centre from the crown, degrees.
             * @default 0
             */
            phi_deg: number;
            /**
             * @description Angle of its length to the circumferential direction, degrees: 0 is x, 90 is y.
             * @default 0
             */
            angle_deg: number;
            /** @description Glue that holds the film; absent: it can't slide on the wall. */
            glue?: components["schemas"]["GlueDocument"] | null;
            /**
             * @description Constants of the piezoelectric layer, which makes charge of its stress.
             * @default {
             *       "d31_pc_per_n": 23,
             *       "d32_pc_per_n": 3,
             *       "d33_pc_per_n": -33,
             *       "permittivity_pf_per_m": 110,
             *       "pyro_uc_per_m2_k": 30,
             *       "yield_mpa": 45
             *     }
             */
            piezo: components["schemas"]["PiezoDocument"];
            /**
             * @description Circuit that the film is wired to.
             * @default {
             *       "kind": "open-circuit",
             *       "press_hz": 1,
             *       "noise_mv": 0,
             *       "gain_std": 0.05,
             *       "temperature_k": 0
             *     }
             */
            amplifier: components["schemas"]["AmplifierDocument"];
        } & (unknown & unknown & unknown);
        /** @description A layer of a film. The usual one is of PVDF, as piezoelectric films are made of. */
        FilmLayerDocument: {
            /**
             * @description Young's modulus, MPa.
             * @default 2500
             */
            modulus_mpa: number;
            /**
             * @description Poisson's ratio.
             * @default 0.34
             */
            poisson_ratio: number;
            /**
             * @description Thickness, mm.
             * @default 0.05
             */
            thickness_mm: number;
            /**
             * @description Whether this is the layer that makes charge.
             * @default false
             */
            piezo: boolean;
        };
        /** @description A layer of glue between wall and film: it shears. The usual one is a soft transfer tape. */
        GlueDocument: {
            /**
             * @description Shear modulus, MPa.
             * @default 0.5
             */
            shear_modulus_mpa: number;
            /**
             * @description Thickness, mm.
             * @default 0.05
             */
            thickness_mm: number;
        };
        /** @description Constants of a piezoelectric polymer. The usual ones are of poly(vinylidene fluoride), stretched in one direction. */
        PiezoDocument: {
            /**
             * @description Charge by stress along the length, in which it was stretched, pC/N.
             * @default 23
             */
            d31_pc_per_n: number;
            /**
             * @description Charge by stress across, pC/N.
             * @default 3
             */
            d32_pc_per_n: number;
            /**
             * @description Charge by stress through the thickness, pC/N.
             * @default -33
             */
            d33_pc_per_n: number;
            /**
             * @description Permittivity, pF/m.
             * @default 110
             */
            permittivity_pf_per_m: number;
            /**
             * @description Charge by area and warming, uC/(m2 K).
             * @default 30
             */
            pyro_uc_per_m2_k: number;
            /**
             * @description Stress at which it yields, MPa.
             * @default 45
             */
            yield_mpa: number;
        };
        /** @description Circuit that a film is wired to, and how fast it is pressed. */
        AmplifierDocument: {
            /**
             * @description Open circuit: nothing draws charge.
             * @default open-circuit
             * @constant
             */
            kind: "open-circuit";
            /**
             * @description Presses per second, Hz.
             * @default 1
             */
            press_hz: number;
            /**
             * @description Standard deviation of what it shows without a film, mV.
             * @default 0
             */
            noise_mv: number;
            /**
             * @description Standard deviation of film and amplifier's gain from one to the next, as a share.
             * @default 0.05
             */
            gain_std: number;
            /**
             * @description Standard deviation of the film's temperature within a press, K.
             * @default 0
             */
            temperature_k: number;
            /** @description Voltage to both sides of zero that it can show, V; absent: it isn't known. */
            supply_v?: number;
        } | {
            /**
             * @description A voltage amplifier; the usual one is as a multimeter or an oscilloscope's probe.
             * @constant
             */
            kind: "voltage";
            /**
             * @description Input resistance, megohm.
             * @default 10
             */
            input_mohm: number;
            /**
             * @description Capacitance of the cable to it, pF.
             * @default 0
             */
            cable_pf: number;
            /**
             * @description Presses per second, Hz.
             * @default 1
             */
            press_hz: number;
            /**
             * @description Standard deviation of what it shows without a film, mV.
             * @default 0
             */
            noise_mv: number;
            /**
             * @description Standard deviation of film and amplifier's gain from one to the next, as a share.
             * @default 0.05
             */
            gain_std: number;
            /**
             * @description Standard deviation of the film's temperature within a press, K.
             * @default 0
             */
            temperature_k: number;
            /** @description Voltage to both sides of zero that it can show, V; absent: it isn't known. */
            supply_v?: number;
        } | {
            /**
             * @description A charge amplifier; the usual one has a time constant of ten seconds.
             * @constant
             */
            kind: "charge";
            /**
             * @description Feedback capacitance, nF.
             * @default 10
             */
            feedback_nf: number;
            /**
             * @description Feedback resistance, megohm.
             * @default 1000
             */
            feedback_mohm: number;
            /**
             * @description Presses per second, Hz.
             * @default 1
             */
            press_hz: number;
            /**
             * @description Standard deviation of what it shows without a film, mV.
             * @default 0
             */
            noise_mv: number;
            /**
             * @description Standard deviation of film and amplifier's gain from one to the next, as a share.
             * @default 0.05
             */
            gain_std: number;
            /**
             * @description Standard deviation of the film's temperature within a press, K.
             * @default 0
             */
            temperature_k: number;
            /** @description Voltage to both sides of zero that it can show, V; absent: it isn't known. */
            supply_v?: number;
        };
        /** @description Loads of the cavity. */
        PressureDocument: {
            /**
             * @description Internal pressure, positive when it inflates, MPa.
             * @default 0.2
             */
            internal_mpa: number;
        };
        /** @description Rigid height field over stations along the circumference, each pressed in by its own depth, below a wheel that may lean. */
        GroundDocument: {
            /**
             * @description Number of stations, odd; the length of `depths_mm` where there is one.
             * @default 5
             */
            stations: number;
            /**
             * @description Horizontal distance of neighbouring stations, mm.
             * @default 5.5
             */
            station_spacing_mm: number;
            /**
             * @description Shape functions of the height field. `bspline`: Uniform cubic B-splines. `hat`: Piecewise linear.
             * @default bspline
             * @enum {string}
             */
            station_functions: "bspline" | "hat";
            /**
             * @description Depth of each station, mm, along the ground's normal from where flat ground touches the inflated tire; none where a load is given.
             * @default [
             *       1,
             *       1,
             *       1,
             *       1,
             *       1
             *     ]
             */
            depths_mm: number[];
            /** @description Force along its normal with which a flat ground presses on the whole tire, N, in place of depths. */
            load_n?: number;
            /**
             * @description Ways by which the ground is dragged once it presses, mm: along the wheel (x, rolling direction) and across it (y, along the axle).
             * @default [
             *       0,
             *       0
             *     ]
             */
            shift_mm: number[];
            /**
             * @description Inclination of the wheel to the ground's normal, degrees, right-handed about x: a positive one leans the top towards -y and presses the side at negative section angles.
             * @default 0
             */
            camber_deg: number;
            /** @description Profile of the ground beside its stations, the same at every depth; a plane when left out. */
            profile?: components["schemas"]["GroundProfileDocument"];
        };
        /** @description Profile of the ground: the highest points of a sphere, a cylinder and an edge are as high as the stations' ground, the mean of rough ground is. */
        GroundProfileDocument: {
            /**
             * @description Kind of the profile. `sphere`: A sphere; beyond nine tenths of its radius a cone goes on from there. `cylinder`: A cylinder that lies on the ground; beyond nine tenths of its radius planes go on from there. `edge`: A rounded edge, behind which the ground falls off. `rough`: Rough ground.
             * @default sphere
             * @enum {string}
             */
            kind: "sphere" | "cylinder" | "edge" | "rough";
            /**
             * @description Radius of the round, mm.
             * @default 10
             */
            radius_mm: number;
            /**
             * @description Place of its highest point, along the wheel (x, rolling direction) and across it (y, along the axle) from where the tire touches flat ground, mm.
             * @default [
             *       0,
             *       0
             *     ]
             */
            place_mm: number[];
            /**
             * @description Direction of a cylinder's axis or an edge, degrees from the rolling direction; 90 is across the wheel. An edge falls off to the left of it; a sphere and rough ground have none.
             * @default 90
             */
            direction_deg: number;
            /** @description Standard deviation of rough ground's height, mm; 0.1 when left out there. */
            rms_mm?: number;
            /** @description Distance over which the correlation of rough ground's heights falls to 1/e, mm, at least three deviations; 5 when left out there. */
            correlation_mm?: number;
            /** @description Seed from which rough ground is drawn; 1 when left out there. */
            seed?: number;
        };
        /** @description Contact of tire and ground. */
        ContactDocument: {
            /**
             * @description Coulomb friction coefficient.
             * @default 0
             */
            friction: number;
            /** @description Contact stiffness, N/mm^3; absent: scaled from the rubber's stiffness and the wall. */
            penalty_n_per_mm3?: number;
        };
        /** @description Fineness of the model. */
        ModelDocument: {
            /**
             * @description Mesh level. `draft`: Mesh for a first look. `coarse`: Mesh for a look with an error; it shows the error of the standard level. `standard`: Mesh for placement decisions. `reference`: Mesh for judging the others.
             * @default standard
             * @enum {string}
             */
            level: "draft" | "coarse" | "standard" | "reference";
        };
        /** @description An uncertain field of the scene. */
        InputDocument: {
            /** @description Name, like no other's. */
            name: string;
            /**
             * @description Path of a number of the scene.
             * @example ground.depths_mm[0]
             */
            vary: string;
            /** @description Distribution of its values. */
            distribution: components["schemas"]["DistributionDocument"];
        };
        /** @description A law of an input. */
        DistributionDocument: {
            /** @constant */
            kind: "uniform";
            min: number;
            max: number;
            /** @description Lower and upper bound. */
            truncate?: number[];
        } | {
            /** @constant */
            kind: "normal";
            mean: number;
            std: number;
            /** @description Lower and upper bound. */
            truncate?: number[];
        } | {
            /** @constant */
            kind: "lognormal";
            mu: number;
            sigma: number;
            /** @description Lower and upper bound. */
            truncate?: number[];
        } | {
            /** @constant */
            kind: "exponential";
            rate: number;
            /** @description Lower and upper bound. */
            truncate?: number[];
        } | {
            /** @constant */
            kind: "gamma";
            shape: number;
            scale: number;
            /** @description Lower and upper bound. */
            truncate?: number[];
        } | {
            /** @constant */
            kind: "weibull";
            shape: number;
            scale: number;
            /** @description Lower and upper bound. */
            truncate?: number[];
        } | {
            /** @constant */
            kind: "beta";
            alpha: number;
            beta: number;
            /** @default 0 */
            min: number;
            /** @default 1 */
            max: number;
            /** @description Lower and upper bound. */
            truncate?: number[];
        } | {
            /** @constant */
            kind: "gumbel";
            location: number;
            scale: number;
            /** @description Lower and upper bound. */
            truncate?: number[];
        } | {
            /** @constant */
            kind: "triangular";
            min: number;
            mode: number;
            max: number;
            /** @description Lower and upper bound. */
            truncate?: number[];
        };
        /** @description Candidate places for films. */
        CandidatesDocument: {
            /**
             * @description Places that are ranked. `P1-P5`: Five places of the inner surface above the stations.
             * @default P1-P5
             * @enum {string}
             */
            points: "P1-P5";
            /**
             * @description Strains that are asked for.
             * @default [
             *       "x",
             *       "y"
             *     ]
             */
            directions: ("x" | "y")[];
            /** @description Dense map of candidates; without it the ranked places alone. */
            grid?: components["schemas"]["GridDocument"];
        };
        /** @description A regular grid on the inner surface, centred on the contact, both ends included. */
        GridDocument: {
            /** @description Points along the circumference, odd. */
            circumferential: number;
            /** @description Points from bead to bead, odd. */
            meridional: number;
            /**
             * @description Half of the circumferential extent, degrees.
             * @default 45
             */
            half_width_deg: number;
        };
        /** @description Layouts to score. */
        LayoutsDocument: {
            /**
             * @description Numbers of films of the menu: each along every direction, and as all directions in one place or in turn. Without spacings_deg, units, free and search the common menu.
             * @default [
             *       3,
             *       4,
             *       6,
             *       8,
             *       9,
             *       10,
             *       12,
             *       15,
             *       18,
             *       20,
             *       24,
             *       30,
             *       36,
             *       48
             *     ]
             */
            films: number[];
            /** @description Angles between neighbouring units, degrees; each divides 360. */
            spacings_deg?: number[];
            /** @description Numbers of units, beside those of the spacings. */
            units?: number[];
            /**
             * @description Places of the units in the section.
             * @default [
             *       "crown",
             *       "shoulder",
             *       "sidewall"
             *     ]
             */
            positions: ("crown" | "shoulder" | "sidewall")[];
            /** @description Section angles beside the positions', degrees from the crown. */
            section_deg?: number[];
            /** @description Sets of directions of a unit's films; those that the study asks for when left out. */
            directions?: (("x" | "y") | number)[][];
            /**
             * @description Whether units of several films are also scored with their films spread between the units.
             * @default false
             */
            staggered: boolean;
            /** @description Layouts film by film. */
            free?: components["schemas"]["FreeLayoutDocument"][];
            /** @description Layouts to search for. */
            search?: components["schemas"]["LayoutSearchDocument"];
            /** @description Films that are glued on already: part of every layout of the menu, of rings and of a search, and counted. A ring is turned until most of its films keep clear of them and of `forbidden_deg`, and goes without the others. */
            taken?: components["schemas"]["FilmPlaceDocument"][];
            /** @description Sectors of the wheel where no film lies, as a valve's or a seam's: from one angle to another in the rolling direction, degrees. */
            forbidden_deg?: number[][];
            /**
             * @description Least distance between the middles of two films on the inner surface, mm.
             * @default 0
             */
            least_distance_mm: number;
            /**
             * @description Model of the films: `bare`; or glued on with their stiffness and read in volts: `coupled`, solved with the tire around the wheel, or `transfer`, by two coupled solves of a film above the contact. `coupled` when left out of a study whose scene or signals have a film glued on.
             * @enum {string}
             */
            film?: "bare" | "transfer" | "coupled";
            /** @description Length and width of all films, mm; points when left out, the glued film's where it is glued on. */
            size_mm?: number[];
            /** @description Further lengths and widths that the candidates have, mm. */
            candidate_sizes_mm?: number[][];
            /** @description Depths at which layouts are scored, mm; the mean one when left out. */
            depths_mm?: number[];
            /** @description Forces in place of depths, N. */
            loads_n?: number[];
            /**
             * @description Noise of a film over the crown's largest signal.
             * @default 0.02
             */
            noise_share: number;
            /** @description Noise of a bare film, strain. */
            noise_strain?: number;
            /** @description Noise of a glued film, V. */
            noise_v?: number;
            /**
             * @description Standard deviation of a film's gain, relative.
             * @default 0
             */
            gain_std: number;
            /**
             * @description Standard deviation of a film's place around the wheel, degrees.
             * @default 0
             */
            place_std_deg: number;
            /**
             * @description Whether every layout is also scored without the film whose loss costs most.
             * @default false
             */
            dead: boolean;
            /**
             * @description Whether forces along the wheel and across it are unknown, too: takes ground with friction, and a solve of the whole tire for every load and mesh.
             * @default false
             */
            shear: boolean;
            /** @description Laws of what a contact is beside its angle and depth, which an estimate doesn't know: simulated errors are over contacts as they come. Takes `depths_mm`. */
            contacts?: components["schemas"]["LayoutContactsDocument"];
            /** @description What the answer's figures rest on, changed one at a time. */
            assumptions?: components["schemas"]["LayoutAssumptionsDocument"];
            /**
             * @description Mesh level of the layouts' own solves; the study's, the standard at most, when left out. `draft`: Mesh for a first look. `coarse`: Mesh for a look with an error; it shows the error of the standard level. `standard`: Mesh for placement decisions. `reference`: Mesh for judging the others.
             * @enum {string}
             */
            level?: "draft" | "coarse" | "standard" | "reference";
        } & (unknown & unknown & unknown);
        /** @description Place of a film. */
        FilmPlaceDocument: {
            /**
             * @description Wheel angle, degrees.
             * @default 0
             */
            theta_deg: number;
            /**
             * @description Section angle from the crown, degrees.
             * @default 0
             */
            phi_deg: number;
            /**
             * @description Angle of its length to the circumferential direction, degrees: 0 is x, 90 is y.
             * @default 0
             */
            angle_deg: number;
        };
        /** @description A layout film by film. */
        FreeLayoutDocument: {
            /** @description Name of the layout. */
            name: string;
            /** @description Films, one by one. */
            films: components["schemas"]["FilmPlaceDocument"][];
        };
        /** @description The best of all layouts of so many films. Films that overlap, by their `size_mm`, are none. */
        LayoutSearchDocument: {
            /** @description Numbers of films. */
            films: number[];
            /**
             * @description Places around the wheel.
             * @default 24
             */
            slots: number;
            /**
             * @description Section angles, degrees from the crown.
             * @default [
             *       0
             *     ]
             */
            section_deg: number[];
            /**
             * @description Directions of the films.
             * @default [
             *       "x",
             *       "y"
             *     ]
             */
            directions: (("x" | "y") | number)[];
            /** @description Films that are glued on already, besides those that are `taken` for all layouts: part of every layout, and counted in `films`. */
            fixed?: components["schemas"]["FilmPlaceDocument"][];
            /** @description Sectors of the wheel where no film lies, as a valve's or a seam's: from one angle to another in the rolling direction, degrees. */
            forbidden_deg?: number[][];
            /**
             * @description Least distance between the middles of two films on the inner surface, mm.
             * @default 0
             */
            least_distance_mm: number;
        };
        /** @description Laws of contacts; what has none is as in the scene. */
        LayoutContactsDocument: {
            /** @description Law of the wheel's inclination, degrees, within -30 to 30. */
            camber_deg?: components["schemas"]["DistributionDocument"];
            /** @description Law of the force along the wheel over the vertical one, within four fifths of the least friction. */
            traction?: components["schemas"]["DistributionDocument"];
            /** @description Law of the force across the wheel over the vertical one, within four fifths of the least friction. */
            side_traction?: components["schemas"]["DistributionDocument"];
            /** @description Law of each station's depth over the contact's, less one: independent of the others. */
            uneven?: components["schemas"]["DistributionDocument"];
            /** @description Law of each station's height over the contact's plane, mm, independent of the others: rough ground of that deviation, whatever the depth. Takes the place of `uneven`. */
            rough_mm?: components["schemas"]["DistributionDocument"];
            /** @description Law of the internal pressure over the scene's. */
            pressure_factor?: components["schemas"]["DistributionDocument"];
            /** @description Law of the ground's friction over the scene's. */
            friction_factor?: components["schemas"]["DistributionDocument"];
            /**
             * @description Scatter of films over these contacts, as an estimate takes it: known of all films together, so that what contacts differ in is estimated, too, or averaged over, as noise of each film. `together`: Known of all films together: what contacts differ in is estimated beside angle and depth. `each`: Noise of each film for its own: averaged over.
             * @default together
             * @enum {string}
             */
            scatter: "together" | "each";
            /**
             * @description Number of contacts that are solved to judge the response surface, and left out of it. Each is a whole tire with friction; 30 tell its largest error.
             * @default 3
             */
            checks: number;
        };
        /** @description Values to which what the answer's figures rest on is changed, one at a time. */
        LayoutAssumptionsDocument: {
            /**
             * @description Noise over the layouts' own.
             * @default 2
             */
            noise_factor: number;
            /**
             * @description Standard deviation of a drift beside the noise, over the crown's largest signal.
             * @default 0.02
             */
            drift_share: number;
            /**
             * @description Standard deviation of a film's gain, relative.
             * @default 0.1
             */
            gain_std: number;
            /**
             * @description Standard deviation of a film's place around the wheel, degrees.
             * @default 2
             */
            place_std_deg: number;
            /** @description Internal pressure over the scene's, unknown to an estimate; not changed when left out. */
            pressure_factor?: number;
            /** @description Inclination of the wheel, degrees, unknown to an estimate; not changed when left out. */
            camber_deg?: number;
            /** @description Friction of the ground, unknown to an estimate; not changed when left out. */
            friction?: number;
            /**
             * @description Model of the films in place of the layouts' own, which an estimate knows; not changed when left out. Glued ones are solved around the wheel. `bare`: Film that follows the wall and resists nothing. `transfer`: Bare, its strains made tensions by a matrix that two coupled solves give. `coupled`: Film glued to the wall, with its stiffness.
             * @enum {string}
             */
            film?: "bare" | "transfer" | "coupled";
        };
        /** @description Question that a study's layouts answer: the best with so many films, or the fewest films that keep errors within limits. */
        QuestionDocument: {
            /** @description Most films of a layout, those that are glued on already among them. */
            films?: number;
            /** @description Largest error of the contact angle that is allowed, degrees: of 95 in 100 contacts at the worst load. */
            angle_deg?: number;
            /** @description Largest error of the vertical force that is allowed, N: root mean square at the worst load. */
            force_n?: number;
            /** @description Most that a layout may cost, in the currency of `film_cost` and `channel_cost`. */
            cost?: number;
            /** @description Cost of a film that isn't glued on already. */
            film_cost?: number;
            /** @description Cost of a channel of the amplifier: every film has one. */
            channel_cost?: number;
        };
        /** @description Method that computes the indices. */
        MethodDocument: {
            /**
             * @description Kind of method.
             * @default mdrm
             * @enum {string}
             */
            kind: "mdrm" | "bivariate" | "tensor" | "pce" | "saltelli" | "auto";
            /**
             * @description Gauss nodes of each input.
             * @default 5
             */
            nodes: number;
            /**
             * @description Points off the lines, for the error.
             * @default 5
             */
            check_points: number;
            /**
             * @description Points of pce, base points of saltelli.
             * @default 200
             */
            samples: number;
            /**
             * @description Most runs of auto.
             * @default 1000
             */
            most_runs: number;
            /**
             * @description Seed of what is random.
             * @default 1
             */
            seed: number;
            /**
             * @description Largest error of an index at which auto stops.
             * @default 0.02
             */
            tolerance: number;
        };
        /** @description Accuracy that is asked of the answer. */
        AccuracyDocument: {
            /**
             * @description Level of the mesh; the scene's when no accuracy is asked for. `draft`: Mesh for a first look. `coarse`: Mesh for a look with an error; it shows the error of the standard level. `standard`: Mesh for placement decisions. `reference`: Mesh for judging the others.
             * @enum {string}
             */
            preset?: "draft" | "coarse" | "standard" | "reference";
            /** @description Largest error of any first-order index, absolute. */
            tolerance?: number;
            /** @description Wall-clock time, s. */
            budget_s?: number;
        };
        /** @description Films' signals over loads, pressures and contact angles. */
        SignalsDocument: {
            /**
             * @description Loads at the tire's own pressure, N.
             * @default [
             *       1,
             *       2,
             *       5,
             *       10,
             *       15,
             *       20,
             *       30
             *     ]
             */
            loads_n: number[];
            /**
             * @description Internal pressures, MPa.
             * @default [
             *       0.1,
             *       0.2,
             *       0.3
             *     ]
             */
            pressures_mpa: number[];
            /**
             * @description Load of the pressures, N.
             * @default 10
             */
            at_load_n: number;
            /**
             * @description Load of the contact angles, N.
             * @default 20
             */
            contact_load_n: number;
            /**
             * @description Wheel angles from a film to the contact, degrees.
             * @default [
             *       0,
             *       5,
             *       10,
             *       15,
             *       20,
             *       25,
             *       30
             *     ]
             */
            contact_deg: number[];
            /**
             * @description Places of the films in the section.
             * @default [
             *       "crown",
             *       "shoulder",
             *       "sidewall"
             *     ]
             */
            positions: ("crown" | "shoulder" | "sidewall")[];
            /**
             * @description Directions along which the films' length lies.
             * @default [
             *       "x",
             *       "y"
             *     ]
             */
            directions: ("x" | "y")[];
            /**
             * @description Models of the films.
             * @default [
             *       "bare",
             *       "transfer",
             *       "coupled"
             *     ]
             */
            films: ("bare" | "transfer" | "coupled")[];
            /** @description The film, as a scene's; the scene's own, or a thin one, when left out. */
            film?: components["schemas"]["UnplacedFilmDocument"];
            /** @description Further tires beside the study's own. */
            tires?: components["schemas"]["FurtherTireDocument"][];
        };
        /** @description A film without its place, which the signals say. */
        UnplacedFilmDocument: {
            /**
             * @description Young's modulus, MPa.
             * @default 2500
             */
            modulus_mpa: number;
            /**
             * @description Poisson's ratio.
             * @default 0.34
             */
            poisson_ratio: number;
            /**
             * @description Thickness, mm.
             * @default 0.05
             */
            thickness_mm: number;
            /** @description Layers from the wall inwards, in place of the fields of one. */
            layers?: components["schemas"]["FilmLayerDocument"][];
            /**
             * @description Extent along its first axis, mm.
             * @default 5
             */
            length_mm: number;
            /**
             * @description Extent across, mm.
             * @default 5
             */
            width_mm: number;
            /** @description Glue that holds the film; absent: it can't slide on the wall. */
            glue?: components["schemas"]["GlueDocument"] | null;
            /**
             * @description Constants of the piezoelectric layer, which makes charge of its stress.
             * @default {
             *       "d31_pc_per_n": 23,
             *       "d32_pc_per_n": 3,
             *       "d33_pc_per_n": -33,
             *       "permittivity_pf_per_m": 110,
             *       "pyro_uc_per_m2_k": 30,
             *       "yield_mpa": 45
             *     }
             */
            piezo: components["schemas"]["PiezoDocument"];
            /**
             * @description Circuit that the film is wired to.
             * @default {
             *       "kind": "open-circuit",
             *       "press_hz": 1,
             *       "noise_mv": 0,
             *       "gain_std": 0.05,
             *       "temperature_k": 0
             *     }
             */
            amplifier: components["schemas"]["AmplifierDocument"];
        };
        /** @description A tire beside the study's own, with loads and pressures where it bears others. */
        FurtherTireDocument: {
            /** @description Name, like no other's. */
            name: string;
            /** @description The tire. */
            scene: components["schemas"]["ChangedSceneDocument"] | string;
            /** @description Loads at the tire's own pressure, N. */
            loads_n?: number[];
            /** @description Internal pressures, MPa. */
            pressures_mpa?: number[];
            /** @description Load of the pressures, N. */
            at_load_n?: number;
            /** @description Load of the contact angles, N. */
            contact_load_n?: number;
        };
        /** @description A virtual rig. */
        RigDocument: {
            /**
             * @description Gait of the foot.
             * @default {
             *       "frequency": {
             *         "kind": "randomised",
             *         "min_hz": 1,
             *         "max_hz": 5
             *       },
             *       "contact_deg": [
             *         0,
             *         30
             *       ],
             *       "load_n": [
             *         0,
             *         30
             *       ],
             *       "duty": 0.5,
             *       "shear_share": 0.6,
             *       "run_s": 60
             *     }
             */
            gait: components["schemas"]["GaitDocument"];
            /**
             * @description Circuit and converter that films are wired to.
             * @default {
             *       "kind": "charge",
             *       "feedback_nf": 10,
             *       "feedback_mohm": 1000,
             *       "bits": 12
             *     }
             */
            electronics: components["schemas"]["ElectronicsDocument"];
            /**
             * @description Noise beside the films' own signals.
             * @default {
             *       "white_share": 0.01,
             *       "thermal_k": 293,
             *       "drift_share": 0.005,
             *       "drift_time_s": 60,
             *       "warming_k_per_min": 0.1,
             *       "gain_std": 0.05
             *     }
             */
            noise: components["schemas"]["NoiseDocument"];
            /**
             * @description Sensor that measures the forces.
             * @default {
             *       "rate_hz": 200,
             *       "offset_s": 0.0017,
             *       "ppm": 20,
             *       "noise_n": 0.05
             *     }
             */
            force_sensor: components["schemas"]["ForceSensorDocument"];
            /**
             * @description Relaxation of the rubber; empty where it doesn't relax.
             * @default [
             *       {
             *         "share": 0.1,
             *         "time_s": 0.3
             *       }
             *     ]
             */
            relaxation: components["schemas"]["BranchDocument"][];
            /**
             * @description Whether the films' charges relax as the force does: those of stiff glued films do, which the force stretches; those of soft ones follow the depth.
             * @default true
             */
            films_follow_force: boolean;
            /**
             * @description Readings of each film a second, Hz.
             * @default 200
             */
            film_rate_hz: number;
            /**
             * @description Runs, each with gains of its own: sessions.
             * @default 4
             */
            runs: number;
            /**
             * @description Seed of all that is drawn at random.
             * @default 1
             */
            seed: number;
            /**
             * @description Tires that estimators are tried on, too.
             * @default []
             */
            other_tires: components["schemas"]["OtherTireDocument"][];
        };
        /** @description Gait of a foot. */
        GaitDocument: {
            /**
             * @description Turns of the crank a second.
             * @default {
             *       "kind": "randomised",
             *       "min_hz": 1,
             *       "max_hz": 5
             *     }
             */
            frequency: components["schemas"]["FrequencyDocument"];
            /**
             * @description Least and greatest wheel angle of the contact, degrees.
             * @default [
             *       0,
             *       30
             *     ]
             */
            contact_deg: number[];
            /**
             * @description Least and greatest load at the deepest point of a stance, N.
             * @default [
             *       0,
             *       30
             *     ]
             */
            load_n: number[];
            /**
             * @description Share of a turn in which the ground is touched.
             * @default 0.5
             */
            duty: number;
            /**
             * @description Share of the shift at which the contact slides that a stance may use.
             * @default 0.6
             */
            shear_share: number;
            /** @description Number of stances of a run, in place of its length. */
            stances?: number;
            /** @description Length of a run, s; 60 when left out. */
            run_s?: number;
        } & unknown;
        /** @description Turns of the crank a second. A turn has one speed from its begin to its end. */
        FrequencyDocument: {
            /**
             * @description All the same.
             * @constant
             */
            kind: "fixed";
            /**
             * @description Turns a second, Hz.
             * @default 2
             */
            hz: number;
        } | {
            /**
             * @description Frequency drawn evenly between two for each turn.
             * @default randomised
             * @constant
             */
            kind: "randomised";
            /**
             * @description Slowest turn, Hz.
             * @default 1
             */
            min_hz: number;
            /**
             * @description Fastest turn, Hz.
             * @default 5
             */
            max_hz: number;
        } | {
            /**
             * @description Frequency that goes from the one to the other in equal parts over a run.
             * @constant
             */
            kind: "transition";
            /**
             * @description Frequency at the run's begin, Hz.
             * @default 1
             */
            from_hz: number;
            /**
             * @description Frequency at its end, Hz.
             * @default 5
             */
            to_hz: number;
        };
        /** @description Circuit and converter that films are wired to. */
        ElectronicsDocument: {
            /**
             * @description Open circuit: nothing draws charge.
             * @constant
             */
            kind: "open-circuit";
            /**
             * @description Bits of the converter; 0 for one that doesn't round.
             * @default 12
             */
            bits: number;
            /** @description A time constant in place of the circuit's own, s; the volts of a held charge stay. */
            time_constant_s?: number;
            /** @description Largest reading, V: it reads from minus this to this; twice each film's full scale where none is set. */
            range_v?: number;
        } | {
            /**
             * @description A voltage amplifier; the usual one is as a multimeter or an oscilloscope's probe.
             * @constant
             */
            kind: "voltage";
            /**
             * @description Input resistance, megohm.
             * @default 10
             */
            input_mohm: number;
            /**
             * @description Capacitance of the cable to it, pF.
             * @default 0
             */
            cable_pf: number;
            /**
             * @description Bits of the converter; 0 for one that doesn't round.
             * @default 12
             */
            bits: number;
            /** @description A time constant in place of the circuit's own, s; the volts of a held charge stay. */
            time_constant_s?: number;
            /** @description Largest reading, V: it reads from minus this to this; twice each film's full scale where none is set. */
            range_v?: number;
        } | {
            /**
             * @description A charge amplifier; the usual one has a time constant of ten seconds.
             * @default charge
             * @constant
             */
            kind: "charge";
            /**
             * @description Feedback capacitance, nF.
             * @default 10
             */
            feedback_nf: number;
            /**
             * @description Feedback resistance, megohm.
             * @default 1000
             */
            feedback_mohm: number;
            /**
             * @description Bits of the converter; 0 for one that doesn't round.
             * @default 12
             */
            bits: number;
            /** @description A time constant in place of the circuit's own, s; the volts of a held charge stay. */
            time_constant_s?: number;
            /** @description Largest reading, V: it reads from minus this to this; twice each film's full scale where none is set. */
            range_v?: number;
        };
        /** @description Noise beside the films' own signals. */
        NoiseDocument: {
            /**
             * @description Standard deviation of white noise, as a share of a film's full scale in held volts.
             * @default 0.01
             */
            white_share: number;
            /**
             * @description Temperature of the circuit's resistance, K; 0 for none of its noise.
             * @default 293
             */
            thermal_k: number;
            /**
             * @description Standard deviation that the drift comes to, as a share of full scale.
             * @default 0.005
             */
            drift_share: number;
            /**
             * @description Time constant of the drift, s.
             * @default 60
             */
            drift_time_s: number;
            /**
             * @description Warming of all films, K a minute.
             * @default 0.1
             */
            warming_k_per_min: number;
            /**
             * @description Standard deviation of the films' gains, drawn once a run.
             * @default 0.05
             */
            gain_std: number;
        };
        /** @description Sensor that measures the forces. */
        ForceSensorDocument: {
            /**
             * @description Readings a second by its own clock, Hz.
             * @default 200
             */
            rate_hz: number;
            /**
             * @description Time of its first reading after the films' first one, s.
             * @default 0.0017
             */
            offset_s: number;
            /**
             * @description Excess of its intervals over what they should be, parts in a million.
             * @default 20
             */
            ppm: number;
            /**
             * @description Standard deviation of its white noise, N.
             * @default 0.05
             */
            noise_n: number;
        };
        /** @description A Prony branch of the rubber. */
        BranchDocument: {
            /**
             * @description Force that it bears at first, as a share of the slow force.
             * @default 0.1
             */
            share: number;
            /**
             * @description Time constant, s.
             * @default 0.3
             */
            time_s: number;
        };
        /** @description A tire that differs from the study's. */
        OtherTireDocument: {
            /**
             * @description Thickness of its wall over that of the study's.
             * @default 1
             */
            wall_factor: number;
            /**
             * @description Pressure over that of the study's.
             * @default 1
             */
            pressure_factor: number;
            /**
             * @description Coefficient of friction of the ground over that of the study's.
             * @default 1
             */
            friction_factor: number;
            /**
             * @description Whether estimators learn from it, too: runs are shared out by turns, the study's own tire first.
             * @default false
             */
            learnt: boolean;
            /**
             * @description Mesh level, where it has another one. `draft`: Mesh for a first look. `coarse`: Mesh for a look with an error; it shows the error of the standard level. `standard`: Mesh for placement decisions. `reference`: Mesh for judging the others.
             * @enum {string}
             */
            level?: "draft" | "coarse" | "standard" | "reference";
        };
        /** @description Scene: what is pressed on which ground, by how much, and how finely it is modelled. */
        SceneDocument: {
            /**
             * @description Shape of the tire.
             * @default {
             *       "kind": "tire",
             *       "outer_radius_mm": 50,
             *       "section_radius_mm": 12.5,
             *       "wall_mm": 3,
             *       "bead_angle_deg": 120
             *     }
             */
            geometry: components["schemas"]["GeometryDocument"];
            /**
             * @description Rubber.
             * @default {
             *       "model": "mooney-rivlin",
             *       "c10_mpa": 0.144,
             *       "c01_mpa": 0.036,
             *       "d1_per_mpa": 0
             *     }
             */
            material: components["schemas"]["MaterialDocument"];
            /** @description Textile layer; absent when the scene has none. */
            carcass?: components["schemas"]["CarcassDocument"] | null;
            /** @description Sensor film glued to the inner surface; absent when it isn't modelled. */
            film?: components["schemas"]["FilmDocument"] | null;
            /**
             * @description Internal pressure.
             * @default {
             *       "internal_mpa": 0.2
             *     }
             */
            pressure: components["schemas"]["PressureDocument"];
            /**
             * @description Rigid ground.
             * @default {
             *       "stations": 5,
             *       "station_spacing_mm": 5.5,
             *       "station_functions": "bspline",
             *       "depths_mm": [
             *         1,
             *         1,
             *         1,
             *         1,
             *         1
             *       ]
             *     }
             */
            ground: components["schemas"]["GroundDocument"];
            /**
             * @description Contact of tire and ground.
             * @default {
             *       "friction": 0
             *     }
             */
            contact: components["schemas"]["ContactDocument"];
            /**
             * @description Fineness of the model.
             * @default {
             *       "level": "standard"
             *     }
             */
            model: components["schemas"]["ModelDocument"];
        };
        /** @description A design. */
        DesignDocument: {
            /** @description Name of the design; what it sets when left out, as `wall_mm = 2.5`. */
            name?: string;
            /** @description Values by path: `geometry.wall_mm` for the scene's fields, `method.nodes` for the study's own. */
            set: Record<string, unknown>;
        };
        /** @description Columns that are meant; patterns have `*` and `?`. */
        ColumnsDocument: {
            /** @description Time; `time_s` or the like, or else the first column where none is named. */
            time?: string;
            /**
             * @description Unit of the time; that of the column's name where none is named, or else seconds. `s`: Seconds. `ms`: Milliseconds. `us`: Microseconds. `ns`: Nanoseconds. `min`: Minutes.
             * @enum {string}
             */
            time_unit?: "s" | "ms" | "us" | "ns" | "min";
            /** @description Signals; all other columns where none are named. */
            signals?: string | string[];
            /** @description Columns that are no signals, whatever the patterns of signals say. */
            not_signals?: string | string[];
            /** @description Forces, N; `fx_n`, `fy_n`, `fz_n` or the like where none are named. */
            forces?: string | string[];
            /** @description Cycles are rows with the same entry of this column, one after another. */
            cycle?: string;
            /** @description Cycles are rows between pauses longer than this, s. */
            pause_s?: number;
            /** @description A cycle goes from one rise of the total force above this threshold to the next, N. */
            threshold_n?: number;
            /** @description Cycles are pieces of this length, s. */
            block_s?: number;
        } & (unknown & unknown & unknown & unknown & unknown & unknown);
        /** @description Treatment of signals, in this order. */
        PreprocessDocument: {
            /**
             * @description Whether each run's first reading is taken off. `auto`: Whichever knows left-out runs better; of one run kept, unless its signals come back to the first reading and that is nearer to them than they are to 0. `subtract`: First readings taken off: runs begin unloaded. `keep`: First readings kept. `unloaded`: Each run's median without a force taken off, which takes forces that are measured as none; of what is estimated later the first reading, or `--start`.
             * @default auto
             * @enum {string}
             */
            start_value: "auto" | "subtract" | "keep" | "unloaded";
            /**
             * @description First readings of a run, or after a zero of a stream, whose median is taken off. While they come it is that of those so far.
             * @default 1
             */
            start_rows: number;
            /**
             * @description Whether the sign of signals is turned.
             * @default false
             */
            turn_sign: boolean;
            /** @description The clock that signals and forces are interpolated to, Hz; none leaves rows as they are. */
            rate_hz?: number;
            /**
             * @description Rows of the moving average; 1 for none.
             * @default 1
             */
            smooth_rows: number;
            /** @description Rows with a signal further than so many robust deviations from its median aren't learnt from; none keeps all. All are tested. */
            outlier_z?: number;
            /**
             * @description Whether rows that hold a suspect sample, themselves or in a window, are learnt from. All are tested. `keep`: Learnt from as all others. `leave-out`: Left out of learning.
             * @default keep
             * @enum {string}
             */
            suspect_rows: "keep" | "leave-out";
            /**
             * @description Method that brings features to one scale. `standardise`: Mean 0, standard deviation 1. `normalise`: Range from 0 to 1. `off`: Features as they are.
             * @default standardise
             * @enum {string}
             */
            scale: "standardise" | "normalise" | "off";
            /**
             * @description Answer to a row of a stream that isn't estimated from. `null`: No estimate: empty cells. `hold`: The last estimate.
             * @default null
             * @enum {string}
             */
            bad_rows: "null" | "hold";
            /** @description A longer time between rows is a pause, s; none for ten typical intervals. Nothing is carried over a pause. */
            pause_s?: number;
        };
        /** @description Features that models are given of the signals. */
        FeaturesDocument: {
            /**
             * @description The sets that are tried.
             * @default [
             *       "raw",
             *       "slopes",
             *       "rolling",
             *       "all"
             *     ]
             */
            sets: ("raw" | "baseline" | "slopes" | "rolling" | "all" | "whole")[];
            /**
             * @description Rows of the rolling mean and variance.
             * @default 10
             */
            window_rows: number;
            /**
             * @description Seconds of the median that is a signal's baseline.
             * @default 1.5
             */
            baseline_s: number;
        };
        /** @description Models that are tried, and how each is learnt. */
        ModelsDocument: {
            /**
             * @description The kinds that are tried, beside the training mean, which always is.
             * @default [
             *       "ridge",
             *       "gpr",
             *       "ann",
             *       "blend"
             *     ]
             */
            kinds: ("mean" | "ridge" | "gpr" | "ann" | "blend")[];
            /**
             * @description Gaussian processes.
             * @default {
             *       "lengths": "shared",
             *       "line": true,
             *       "restarts": 50,
             *       "search_rows": 600,
             *       "most_rows": 3000
             *     }
             */
            gpr: components["schemas"]["GprDocument"];
            /**
             * @description Neural networks.
             * @default {
             *       "layers": [
             *         24,
             *         12
             *       ],
             *       "activation": "tanh",
             *       "output": "linear",
             *       "loss": "mse",
             *       "decay": 0.001,
             *       "iterations": 300,
             *       "networks": 3
             *     }
             */
            ann: components["schemas"]["AnnDocument"];
            /**
             * @description Seed of all that is drawn at random.
             * @default 1
             */
            seed: number;
        };
        /** @description Settings of Gaussian processes. */
        GprDocument: {
            /**
             * @description Length scales: one, or one for each feature. `shared`: A length for all features. `each`: A length for each feature.
             * @default shared
             * @enum {string}
             */
            lengths: "shared" | "each";
            /**
             * @description Whether a line in the features is added, as heavy as the rows make it: beyond what was learnt from, it goes on where the squared exponential falls back to the mean.
             * @default true
             */
            line: boolean;
            /**
             * @description Starts of the search for hyperparameters, drawn at random.
             * @default 50
             */
            restarts: number;
            /**
             * @description Rows from which the hyperparameters are learnt, an even subset.
             * @default 600
             */
            search_rows: number;
            /**
             * @description Rows that the process is conditioned on, an even subset.
             * @default 3000
             */
            most_rows: number;
        };
        /** @description Settings of neural networks. */
        AnnDocument: {
            /**
             * @description Nodes of each hidden layer.
             * @default [
             *       24,
             *       12
             *     ]
             */
            layers: number[];
            /**
             * @description Activation of hidden layers. `linear`: z `sigmoid`: 1 / (1 + exp(-z)) `tanh`: tanh z `relu`: max(z, 0) `elu`: z, or exp(z) - 1 below 0 `softmax`: exp(z_i) over the layer's sum
             * @default tanh
             * @enum {string}
             */
            activation: "linear" | "sigmoid" | "tanh" | "relu" | "elu" | "softmax";
            /**
             * @description Activation of the last layer.
             * @default linear
             * @enum {string}
             */
            output: "linear" | "sigmoid" | "tanh" | "relu" | "elu";
            /**
             * @description Loss that is made small. `mse`: Half the mean squared error. `poisson`: Poisson's negative log likelihood, exp(z) - y z: for forces that are never negative.
             * @default mse
             * @enum {string}
             */
            loss: "mse" | "poisson";
            /**
             * @description Weight of the squared weights in the loss.
             * @default 0.001
             */
            decay: number;
            /**
             * @description Most iterations.
             * @default 300
             */
            iterations: number;
            /**
             * @description Networks whose mean is the estimate, each from weights of its own.
             * @default 3
             */
            networks: number;
        };
        /** @description Validation that judges models. */
        ValidationDocument: {
            /**
             * @description The split that chooses model and features; the strictest there is where none is named: runs, or cycles of one run. `random`: A fifth of the rows, drawn at random: the paper's. Neighbours of what is tested are learnt from. `cycle`: Cycles left out. `run`: Runs left out. `time`: Later rows tested on earlier ones, a gap between. `frequency`: Slow, middling or fast cycles left out.
             * @enum {string}
             */
            by?: "random" | "cycle" | "run" | "time" | "frequency";
            /**
             * @description Time constant of the signals, s: three of them and a window lie between what is learnt and what is tested by time.
             * @default 0
             */
            time_constant_s: number;
        };
        /** @description Inputs of a model that others run, and the method that asks for points. */
        InputsDocument: {
            /** @description Inputs of the model. */
            inputs: components["schemas"]["ModelInputDocument"][];
            /** @description Method that computes the indices. */
            method?: components["schemas"]["ModelMethodDocument"];
        };
        /** @description An input of the model. */
        ModelInputDocument: {
            /** @description Name, like no other's. */
            name: string;
            /** @description Distribution of its values. */
            distribution: components["schemas"]["DistributionDocument"];
        };
        /** @description Method that computes the indices. */
        ModelMethodDocument: {
            /**
             * @description Kind of method.
             * @default mdrm
             * @enum {string}
             */
            kind: "mdrm" | "bivariate" | "tensor" | "pce" | "saltelli" | "auto";
            /**
             * @description Gauss nodes of each input.
             * @default 5
             */
            nodes: number;
            /**
             * @description Points off the lines, for the error.
             * @default 5
             */
            check_points: number;
            /**
             * @description Points of pce, base points of saltelli.
             * @default 200
             */
            samples: number;
            /**
             * @description Most runs of auto.
             * @default 1000
             */
            most_runs: number;
            /**
             * @description Seed of what is random.
             * @default 1
             */
            seed: number;
            /**
             * @description Largest error of an index at which auto stops.
             * @default 0.02
             */
            tolerance: number;
        };
        /** @description A point of the inner surface and a direction there, as a strain gauge has it. */
        GaugeDocument: {
            /** @description Wheel angle from the contact centre, degrees, positive in the rolling direction. */
            theta_deg: number;
            /** @description Section angle from the crown, degrees; from bead to bead. */
            phi_deg: number;
            /**
             * @description Angle of the material line to the circumferential direction, drawn on the undeformed tire, degrees: 0 is x, 90 is y.
             * @default 0
             */
            angle_deg: number;
        };
        /** @description Method that computes the indices. */
        AnalysisMethodDocument: {
            /**
             * @description Kind of method.
             * @default auto
             * @enum {string}
             */
            kind: "mdrm" | "bivariate" | "tensor" | "pce" | "saltelli" | "auto";
            /**
             * @description Gauss nodes of each input.
             * @default 5
             */
            nodes: number;
            /**
             * @description Points off the lines, for the error.
             * @default 5
             */
            check_points: number;
            /**
             * @description Points of pce, base points of saltelli.
             * @default 200
             */
            samples: number;
            /**
             * @description Most runs of auto.
             * @default 1000
             */
            most_runs: number;
            /**
             * @description Seed of what is random.
             * @default 1
             */
            seed: number;
            /**
             * @description Largest error of an index at which auto stops.
             * @default 0.02
             */
            tolerance: number;
        };
        /** @description Values of outputs by point; every digit of them counts. */
        ListedValuesDocument: {
            /** @description Names of the outputs. */
            outputs: string[];
            /** @description Point of each row; 0, 1, 2 and so on when left out. */
            ids?: number[];
            /** @description Values of each point, one an output, null where the run failed. */
            rows: (number | null)[][];
        };
    };
    responses: never;
    parameters: never;
    requestBodies: never;
    headers: never;
    pathItems: never;
}
export type AlikeContacts = components['schemas']['AlikeContacts'];
export type AlikeError = components['schemas']['AlikeError'];
export type AnalysisDocument = components['schemas']['AnalysisDocument'];
export type Answer = components['schemas']['Answer'];
export type AskewError = components['schemas']['AskewError'];
export type AssumptionChange = components['schemas']['AssumptionChange'];
export type AssumptionFindings = components['schemas']['AssumptionFindings'];
export type AwaySweep = components['schemas']['AwaySweep'];
export type BeginningsReport = components['schemas']['BeginningsReport'];
export type CandidateFilm = components['schemas']['CandidateFilm'];
export type Candidates = components['schemas']['Candidates'];
export type CarcassState = components['schemas']['CarcassState'];
export type Certainty = components['schemas']['Certainty'];
export type Choice = components['schemas']['Choice'];
export type Claim = components['schemas']['Claim'];
export type ClaimRow = components['schemas']['ClaimRow'];
export type Climb = components['schemas']['Climb'];
export type ClimbRung = components['schemas']['ClimbRung'];
export type CoarserIndices = components['schemas']['CoarserIndices'];
export type ColumnLook = components['schemas']['ColumnLook'];
export type ColumnSeries = components['schemas']['ColumnSeries'];
export type ComparedAnswer = components['schemas']['ComparedAnswer'];
export type ComparedFigure = components['schemas']['ComparedFigure'];
export type ComparedIndex = components['schemas']['ComparedIndex'];
export type ComparedLocation = components['schemas']['ComparedLocation'];
export type ComparedStudy = components['schemas']['ComparedStudy'];
export type Comparison = components['schemas']['Comparison'];
export type ComparisonAnswer = components['schemas']['ComparisonAnswer'];
export type ComparisonFormat = components['schemas']['ComparisonFormat'];
export type ComparisonTable = components['schemas']['ComparisonTable'];
export type ContactError = components['schemas']['ContactError'];
export type ContactFindings = components['schemas']['ContactFindings'];
export type CountForecast = components['schemas']['CountForecast'];
export type CrownStretchFields_f64 = components['schemas']['CrownStretchFields_f64'];
export type CutPoint = components['schemas']['CutPoint'];
export type DeadFilm = components['schemas']['DeadFilm'];
export type DeadFilmError = components['schemas']['DeadFilmError'];
export type Derivative = components['schemas']['Derivative'];
export type DesignCounts = components['schemas']['DesignCounts'];
export type DesignEstimate = components['schemas']['DesignEstimate'];
export type DesignView = components['schemas']['DesignView'];
export type DriftError = components['schemas']['DriftError'];
export type ElsewhereError = components['schemas']['ElsewhereError'];
export type EngineList = components['schemas']['EngineList'];
export type EngineName = components['schemas']['EngineName'];
export type EngineView = components['schemas']['EngineView'];
export type EntryChange = components['schemas']['EntryChange'];
export type ErrorSources = components['schemas']['ErrorSources'];
export type Estimate = components['schemas']['Estimate'];
export type EstimatorDetail = components['schemas']['EstimatorDetail'];
export type EstimatorDocument = components['schemas']['EstimatorDocument'];
export type EstimatorPage = components['schemas']['EstimatorPage'];
export type EstimatorSummary = components['schemas']['EstimatorSummary'];
export type EstimatorZero = components['schemas']['EstimatorZero'];
export type EvaluationView = components['schemas']['EvaluationView'];
export type Evaluations = components['schemas']['Evaluations'];
export type ExpectedAccuracy = components['schemas']['ExpectedAccuracy'];
export type Extremes = components['schemas']['Extremes'];
export type FailedNode = components['schemas']['FailedNode'];
export type FailedPoint = components['schemas']['FailedPoint'];
export type Fault = components['schemas']['Fault'];
export type FeatureSet = components['schemas']['FeatureSet'];
export type FidelityReport = components['schemas']['FidelityReport'];
export type FieldLoad = components['schemas']['FieldLoad'];
export type FileFormat = components['schemas']['FileFormat'];
export type FilmAnglesReport = components['schemas']['FilmAnglesReport'];
export type FilmCondition = components['schemas']['FilmCondition'];
export type FilmError = components['schemas']['FilmError'];
export type FilmFields = components['schemas']['FilmFields'];
export type FilmKindPlace = components['schemas']['FilmKindPlace'];
export type FilmModel = components['schemas']['FilmModel'];
export type FilmNoise = components['schemas']['FilmNoise'];
export type FilmPair = components['schemas']['FilmPair'];
export type FilmPlace = components['schemas']['FilmPlace'];
export type FilmSignal = components['schemas']['FilmSignal'];
export type FilmState = components['schemas']['FilmState'];
export type FitCost = components['schemas']['FitCost'];
export type FitEstimate = components['schemas']['FitEstimate'];
export type FitProgress = components['schemas']['FitProgress'];
export type FitStage = components['schemas']['FitStage'];
export type ForceError = components['schemas']['ForceError'];
export type ForceFindings = components['schemas']['ForceFindings'];
export type ForcePrice = components['schemas']['ForcePrice'];
export type ForceReport = components['schemas']['ForceReport'];
export type Forecast = components['schemas']['Forecast'];
export type FormMisses = components['schemas']['FormMisses'];
export type FrontLayout = components['schemas']['FrontLayout'];
export type FurtherDesignsDocument = components['schemas']['FurtherDesignsDocument'];
export type GapLook = components['schemas']['GapLook'];
export type GapsLook = components['schemas']['GapsLook'];
export type Gauge = components['schemas']['Gauge'];
export type GaugeError = components['schemas']['GaugeError'];
export type GaugeReading = components['schemas']['GaugeReading'];
export type Grade = components['schemas']['Grade'];
export type GradedNote = components['schemas']['GradedNote'];
export type HandFilm = components['schemas']['HandFilm'];
export type HandLayout = components['schemas']['HandLayout'];
export type HandLayoutsDocument = components['schemas']['HandLayoutsDocument'];
export type Health = components['schemas']['Health'];
export type Holds = components['schemas']['Holds'];
export type Index = components['schemas']['Index'];
export type IndexError = components['schemas']['IndexError'];
export type IndexMap = components['schemas']['IndexMap'];
export type Inflated = components['schemas']['Inflated'];
export type InputReport = components['schemas']['InputReport'];
export type InputShare = components['schemas']['InputShare'];
export type InputsAnswer = components['schemas']['InputsAnswer'];
export type InputsBeside = components['schemas']['InputsBeside'];
export type Kind = components['schemas']['Kind'];
export type Knee = components['schemas']['Knee'];
export type LayoutAnswer = components['schemas']['LayoutAnswer'];
export type LayoutError = components['schemas']['LayoutError'];
export type LayoutFindings = components['schemas']['LayoutFindings'];
export type LayoutLoad = components['schemas']['LayoutLoad'];
export type LayoutScore = components['schemas']['LayoutScore'];
export type LayoutSearch = components['schemas']['LayoutSearch'];
export type Layouts = components['schemas']['Layouts'];
export type LeftOut = components['schemas']['LeftOut'];
export type LeftOutForces = components['schemas']['LeftOutForces'];
export type LeftOutRows = components['schemas']['LeftOutRows'];
export type LiveSolve = components['schemas']['LiveSolve'];
export type LoadScore = components['schemas']['LoadScore'];
export type LoadShear = components['schemas']['LoadShear'];
export type LoadedReport = components['schemas']['LoadedReport'];
export type LocationError = components['schemas']['LocationError'];
export type LocationStrain = components['schemas']['LocationStrain'];
export type Locations = components['schemas']['Locations'];
export type LoginLink = components['schemas']['LoginLink'];
export type LoneSample = components['schemas']['LoneSample'];
export type LoneSamples = components['schemas']['LoneSamples'];
export type Look = components['schemas']['Look'];
export type LookDocument = components['schemas']['LookDocument'];
export type MapLayer = components['schemas']['MapLayer'];
export type MapShape = components['schemas']['MapShape'];
export type MapView = components['schemas']['MapView'];
export type MemberReport = components['schemas']['MemberReport'];
export type MenuFindings = components['schemas']['MenuFindings'];
export type ModelAnalysis = components['schemas']['ModelAnalysis'];
export type ModelIndexError = components['schemas']['ModelIndexError'];
export type ModelOutput = components['schemas']['ModelOutput'];
export type ModelPoints = components['schemas']['ModelPoints'];
export type ModelReport = components['schemas']['ModelReport'];
export type ModelSummary = components['schemas']['ModelSummary'];
export type Output = components['schemas']['Output'];
export type PlaceAnswer = components['schemas']['PlaceAnswer'];
export type Preset = components['schemas']['Preset'];
export type Presets = components['schemas']['Presets'];
export type Preview = components['schemas']['Preview'];
export type ProblemDocument = components['schemas']['ProblemDocument'];
export type Question = components['schemas']['Question'];
export type RankedLayout = components['schemas']['RankedLayout'];
export type RankedLocation = components['schemas']['RankedLocation'];
export type Reached = components['schemas']['Reached'];
export type Readiness = components['schemas']['Readiness'];
export type RecipeDocument = components['schemas']['RecipeDocument'];
export type RecordingDocument = components['schemas']['RecordingDocument'];
export type RecordingFigures = components['schemas']['RecordingFigures'];
export type RecordingLook = components['schemas']['RecordingLook'];
export type RecordingSeries = components['schemas']['RecordingSeries'];
export type Refusal = components['schemas']['Refusal'];
export type Report = components['schemas']['Report'];
export type Response = components['schemas']['Response'];
export type ResponseError = components['schemas']['ResponseError'];
export type RestedReport = components['schemas']['RestedReport'];
export type RestsOn = components['schemas']['RestsOn'];
export type RingLoad = components['schemas']['RingLoad'];
export type Rings = components['schemas']['Rings'];
export type Rung = components['schemas']['Rung'];
export type SceneQuestionDocument = components['schemas']['SceneQuestionDocument'];
export type ScoredLayouts = components['schemas']['ScoredLayouts'];
export type Section = components['schemas']['Section'];
export type SectionNode = components['schemas']['SectionNode'];
export type Sections = components['schemas']['Sections'];
export type ShearError = components['schemas']['ShearError'];
export type ShearScore = components['schemas']['ShearScore'];
export type SheetFilm = components['schemas']['SheetFilm'];
export type SignalAxis = components['schemas']['SignalAxis'];
export type SignalCurve = components['schemas']['SignalCurve'];
export type SignalError = components['schemas']['SignalError'];
export type SignalRow = components['schemas']['SignalRow'];
export type Signals = components['schemas']['Signals'];
export type SignalsAnswer = components['schemas']['SignalsAnswer'];
export type SolveForecast = components['schemas']['SolveForecast'];
export type SolveProgress = components['schemas']['SolveProgress'];
export type SolvedScene = components['schemas']['SolvedScene'];
export type SplitError = components['schemas']['SplitError'];
export type SplitKind = components['schemas']['SplitKind'];
export type SplitReport = components['schemas']['SplitReport'];
export type SplitReports = components['schemas']['SplitReports'];
export type Stage = components['schemas']['Stage'];
export type State = components['schemas']['State'];
export type StrainFields_f64 = components['schemas']['StrainFields_f64'];
export type StrainRing = components['schemas']['StrainRing'];
export type StreamEvent = components['schemas']['StreamEvent'];
export type StressWidth = components['schemas']['StressWidth'];
export type StretchFields_Extremes = components['schemas']['StretchFields_Extremes'];
export type StudyCost = components['schemas']['StudyCost'];
export type StudyDetail = components['schemas']['StudyDetail'];
export type StudyDocument = components['schemas']['StudyDocument'];
export type StudyIdentity = components['schemas']['StudyIdentity'];
export type StudyPage = components['schemas']['StudyPage'];
export type StudyResult = components['schemas']['StudyResult'];
export type StudySummary = components['schemas']['StudySummary'];
export type Surer = components['schemas']['Surer'];
export type SweepDetail = components['schemas']['SweepDetail'];
export type SweepDocument = components['schemas']['SweepDocument'];
export type SweepEstimate = components['schemas']['SweepEstimate'];
export type SweepPage = components['schemas']['SweepPage'];
export type SweepSummary = components['schemas']['SweepSummary'];
export type Table = components['schemas']['Table'];
export type TableError = components['schemas']['TableError'];
export type TableReport = components['schemas']['TableReport'];
export type Taken = components['schemas']['Taken'];
export type TaskCounts = components['schemas']['TaskCounts'];
export type TaskReport = components['schemas']['TaskReport'];
export type TensionFields_Extremes = components['schemas']['TensionFields_Extremes'];
export type ToldQuantity = components['schemas']['ToldQuantity'];
export type Topic = components['schemas']['Topic'];
export type Trade = components['schemas']['Trade'];
export type TradeAnswer = components['schemas']['TradeAnswer'];
export type TradeRow = components['schemas']['TradeRow'];
export type Trend = components['schemas']['Trend'];
export type TrialError = components['schemas']['TrialError'];
export type Verdict = components['schemas']['Verdict'];
export type WheelRing = components['schemas']['WheelRing'];
export type WorstContact = components['schemas']['WorstContact'];
export type WorstForce = components['schemas']['WorstForce'];
export type ZeroDocument = components['schemas']['ZeroDocument'];
export type ChangedSceneDocument = components['schemas']['ChangedSceneDocument'];
export type GeometryDocument = components['schemas']['GeometryDocument'];
export type MaterialDocument = components['schemas']['MaterialDocument'];
export type OgdenTermDocument = components['schemas']['OgdenTermDocument'];
export type CarcassDocument = components['schemas']['CarcassDocument'];
export type FilmDocument = components['schemas']['FilmDocument'];
export type FilmLayerDocument = components['schemas']['FilmLayerDocument'];
export type GlueDocument = components['schemas']['GlueDocument'];
export type PiezoDocument = components['schemas']['PiezoDocument'];
export type AmplifierDocument = components['schemas']['AmplifierDocument'];
export type PressureDocument = components['schemas']['PressureDocument'];
export type GroundDocument = components['schemas']['GroundDocument'];
export type GroundProfileDocument = components['schemas']['GroundProfileDocument'];
export type ContactDocument = components['schemas']['ContactDocument'];
export type ModelDocument = components['schemas']['ModelDocument'];
export type InputDocument = components['schemas']['InputDocument'];
export type DistributionDocument = components['schemas']['DistributionDocument'];
export type CandidatesDocument = components['schemas']['CandidatesDocument'];
export type GridDocument = components['schemas']['GridDocument'];
export type LayoutsDocument = components['schemas']['LayoutsDocument'];
export type FilmPlaceDocument = components['schemas']['FilmPlaceDocument'];
export type FreeLayoutDocument = components['schemas']['FreeLayoutDocument'];
export type LayoutSearchDocument = components['schemas']['LayoutSearchDocument'];
export type LayoutContactsDocument = components['schemas']['LayoutContactsDocument'];
export type LayoutAssumptionsDocument = components['schemas']['LayoutAssumptionsDocument'];
export type QuestionDocument = components['schemas']['QuestionDocument'];
export type MethodDocument = components['schemas']['MethodDocument'];
export type AccuracyDocument = components['schemas']['AccuracyDocument'];
export type SignalsDocument = components['schemas']['SignalsDocument'];
export type UnplacedFilmDocument = components['schemas']['UnplacedFilmDocument'];
export type FurtherTireDocument = components['schemas']['FurtherTireDocument'];
export type RigDocument = components['schemas']['RigDocument'];
export type GaitDocument = components['schemas']['GaitDocument'];
export type FrequencyDocument = components['schemas']['FrequencyDocument'];
export type ElectronicsDocument = components['schemas']['ElectronicsDocument'];
export type NoiseDocument = components['schemas']['NoiseDocument'];
export type ForceSensorDocument = components['schemas']['ForceSensorDocument'];
export type BranchDocument = components['schemas']['BranchDocument'];
export type OtherTireDocument = components['schemas']['OtherTireDocument'];
export type SceneDocument = components['schemas']['SceneDocument'];
export type DesignDocument = components['schemas']['DesignDocument'];
export type ColumnsDocument = components['schemas']['ColumnsDocument'];
export type PreprocessDocument = components['schemas']['PreprocessDocument'];
export type FeaturesDocument = components['schemas']['FeaturesDocument'];
export type ModelsDocument = components['schemas']['ModelsDocument'];
export type GprDocument = components['schemas']['GprDocument'];
export type AnnDocument = components['schemas']['AnnDocument'];
export type ValidationDocument = components['schemas']['ValidationDocument'];
export type InputsDocument = components['schemas']['InputsDocument'];
export type ModelInputDocument = components['schemas']['ModelInputDocument'];
export type ModelMethodDocument = components['schemas']['ModelMethodDocument'];
export type GaugeDocument = components['schemas']['GaugeDocument'];
export type AnalysisMethodDocument = components['schemas']['AnalysisMethodDocument'];
export type ListedValuesDocument = components['schemas']['ListedValuesDocument'];
export type $defs = Record<string, never>;
export type operations = Record<string, never>;

/** What the service takes for each number of a scene: lowest, highest. */
export const RANGES = {
  "geometry/outer_radius_mm": [0.001, 10000],
  "geometry/section_radius_mm": [0.001, 10000],
  "geometry/wall_mm": [0.001, 10000],
  "geometry/bead_angle_deg": [60, 150],
  "material/c10_mpa": [0.000001, 1000000],
  "material/c01_mpa": [0, 1000000],
  "material/d1_per_mpa": [0, 1000000],
  "material/c20_mpa": [-1000000, 1000000],
  "material/c30_mpa": [-1000000, 1000000],
  "material/terms/*/mu_mpa": [-1000000, 1000000],
  "material/terms/*/alpha": [-30, 30],
  "carcass/angle_deg": [0, 90],
  "carcass/stiffness_n_per_mm": [0, 1000000000],
  "carcass/position": [0, 1],
  "carcass/compression_ratio": [0, 1],
  "film/modulus_mpa": [0.000001, 1000000],
  "film/poisson_ratio": [0, 0.5],
  "film/thickness_mm": [0.001, 10000],
  "film/layers/*/modulus_mpa": [0.000001, 1000000],
  "film/layers/*/poisson_ratio": [0, 0.5],
  "film/layers/*/thickness_mm": [0.001, 10000],
  "film/length_mm": [0.001, 10000],
  "film/width_mm": [0.001, 10000],
  "film/theta_deg": [-180, 180],
  "film/phi_deg": [-180, 180],
  "film/angle_deg": [-180, 180],
  "film/glue/shear_modulus_mpa": [0.000001, 1000000],
  "film/glue/thickness_mm": [0.001, 10000],
  "film/piezo/d31_pc_per_n": [-10000, 10000],
  "film/piezo/d32_pc_per_n": [-10000, 10000],
  "film/piezo/d33_pc_per_n": [-10000, 10000],
  "film/piezo/permittivity_pf_per_m": [1, 1000000],
  "film/piezo/pyro_uc_per_m2_k": [-10000, 10000],
  "film/piezo/yield_mpa": [0.000001, 1000000],
  "film/amplifier/press_hz": [0.000001, 1000000],
  "film/amplifier/noise_mv": [0, 1000000000],
  "film/amplifier/gain_std": [0, 1],
  "film/amplifier/temperature_k": [0, 1000],
  "film/amplifier/supply_v": [0.001, 10000],
  "film/amplifier/input_mohm": [0.000001, 1000000000],
  "film/amplifier/cable_pf": [0, 1000000],
  "film/amplifier/feedback_nf": [0.000001, 1000000],
  "film/amplifier/feedback_mohm": [0.000001, 1000000000],
  "pressure/internal_mpa": [0, 10000],
  "ground/stations": [1, 21],
  "ground/station_spacing_mm": [0.001, 10000],
  "ground/depths_mm/*": [0, 10000],
  "ground/load_n": [0, 1000000000],
  "ground/shift_mm/*": [-10000, 10000],
  "ground/camber_deg": [-30, 30],
  "ground/profile/radius_mm": [0.001, 10000],
  "ground/profile/place_mm/*": [-10000, 10000],
  "ground/profile/direction_deg": [-360, 360],
  "ground/profile/rms_mm": [0.001, 10000],
  "ground/profile/correlation_mm": [0.001, 10000],
  "ground/profile/seed": [0, 18446744073709552000],
  "contact/friction": [0, 10],
  "contact/penalty_n_per_mm3": [0.000001, 1000000000],
} as const;

/** Columns of indices. */
export const INDICES_COLUMNS = {
  location: {"at":"/output/location","kind":"text","title":"location","digits":2,"description":"P1, P2, ..."},
  direction: {"at":"/output/direction","kind":"text","title":"direction","digits":2,"description":"`x` circumferential, `y` meridional."},
  input: {"at":"/input/name","kind":"text","title":"input","digits":2,"description":"Name of the input."},
  first_order: {"at":"/own/first_order","kind":"float","unit":"1","title":"first order","digits":2,"description":"First-order index of each input."},
  total: {"at":"/own/total","kind":"float","unit":"1","title":"total","digits":2,"description":"Total index of each input."},
  error_mesh: {"at":"/output/error/mesh","kind":"float","unit":"1","title":"error mesh","digits":2,"description":"Error of the mesh."},
  error_quadrature: {"at":"/output/error/quadrature","kind":"float","unit":"1","title":"error quadrature","digits":2,"description":"Error of the quadrature rule."},
  error_decomposition: {"at":"/output/error/decomposition","kind":"float","unit":"1","title":"error decomposition","digits":2,"description":"Error of the decomposition."},
  error_total: {"at":"/output/error/total","kind":"float","unit":"1","title":"error total","digits":2,"description":"Sum of the parts, the largest over the inputs; null where the mesh's part isn't known."},
  mean_strain: {"at":"/output/mean","kind":"float","unit":"1","title":"mean strain","digits":2,"description":"Mean strain."},
  std_strain: {"at":"/output/std","kind":"float","unit":"1","title":"std strain","digits":2,"description":"Standard deviation of the strain."},
  method: {"at":"/output/method","kind":"text","title":"method","digits":2,"description":"Form that gave `first_order` and `total`: `mdrm`, `additive`, `shifted`, `corrected`, `bivariate`, `tensor`, `pce` or `saltelli`."},
  status: {"at":"/output/status","kind":"text","title":"status","digits":2,"description":"`ok`, `constant`, `product-form-broken` or `unusable`."},
  mdrm_first_order: {"at":"/own/mdrm_first_order","kind":"float","unit":"1","title":"mdrm first order","digits":2,"description":"Indices that M-DRM gave, when its product form is broken."},
} as const;

/** Columns of locations. */
export const LOCATIONS_COLUMNS = {
  rank: {"at":"/location/rank","kind":"integer","title":"rank","digits":2,"description":"1 is best. Equal locations, as mirror images are, share the rank of the first of them, and follow each other in the order of their names."},
  name: {"at":"/location/name","kind":"text","title":"name","digits":2,"description":"P1, P2, ..."},
  input: {"at":"/location/input","kind":"text","title":"input","digits":2,"description":"The input that is this location's own: the depth of the station below it."},
  gsi_x_percent: {"at":"/location/gsi_x_percent","kind":"float","unit":"%","title":"gsi x percent","digits":2,"description":"100 times the first-order index of this location's own depth for the x strain at the centre."},
  gsi_y_percent: {"at":"/location/gsi_y_percent","kind":"float","unit":"%","title":"gsi y percent","digits":2,"description":"100 times the first-order index of this location's own depth for the y strain at the centre."},
  mean_gsi_x_percent: {"at":"/location/mean_gsi_x_percent","kind":"float","unit":"%","title":"mean gsi x percent","digits":2,"description":"Mean over the x strains at all locations."},
  mean_gsi_y_percent: {"at":"/location/mean_gsi_y_percent","kind":"float","unit":"%","title":"mean gsi y percent","digits":2,"description":"Mean over the y strains at all locations."},
  own_gsi_x_percent: {"at":"/location/own_gsi_x_percent","kind":"float","unit":"%","title":"own gsi x percent","digits":2,"description":"For the x strain at this location itself."},
  own_gsi_y_percent: {"at":"/location/own_gsi_y_percent","kind":"float","unit":"%","title":"own gsi y percent","digits":2,"description":"For the y strain at this location itself."},
  mdrm_gsi_x_percent: {"at":"/location/mdrm_gsi_x_percent","kind":"float","unit":"%","title":"mdrm gsi x percent","digits":2,"description":"Index by M-DRM for `gsi_x_percent`, valid or not: the paper's Table 2 as the paper computed it."},
  mdrm_gsi_y_percent: {"at":"/location/mdrm_gsi_y_percent","kind":"float","unit":"%","title":"mdrm gsi y percent","digits":2,"description":"Index by M-DRM for `gsi_y_percent`, valid or not: the paper's Table 2 as the paper computed it."},
  rank_x: {"at":"/location/rank_x","kind":"integer","title":"rank x","digits":2,"description":"Rank by the x strain alone, which equal locations share."},
  rank_y: {"at":"/location/rank_y","kind":"integer","title":"rank y","digits":2,"description":"Rank by the y strain alone, which equal locations share."},
  rank_certain: {"at":"/location/rank_certain","kind":"bool","title":"rank certain","digits":2,"description":"Whether the errors leave no doubt about this rank, which equal locations share."},
  gsi_x_error_percent: {"at":"/location/gsi_x_error_percent","kind":"float","unit":"%","title":"gsi x error percent","digits":2,"description":"Error of `gsi_x_percent`, percentage points."},
  gsi_y_error_percent: {"at":"/location/gsi_y_error_percent","kind":"float","unit":"%","title":"gsi y error percent","digits":2,"description":"Error of `gsi_y_percent`, percentage points."},
} as const;

/** Columns of layouts. */
export const LAYOUTS_COLUMNS = {
  rank: {"at":"/layout/rank","kind":"integer","title":"rank","digits":2,"description":"1 is best. Layouts of equal score share the rank of the first of them."},
  spacing_deg: {"at":"/layout/spacing_deg","kind":"float","unit":"deg","title":"spacing","digits":1,"description":"Angle between neighbouring units, degrees; null of a layout without units."},
  units: {"at":"/layout/units","kind":"integer","title":"units","digits":2,"description":"Number of units; of a layout without units its number of films."},
  position: {"at":"/layout/position","kind":"text","title":"position","digits":2,"description":"Meridional position: a name, an angle such as `30 deg`, or `mixed`."},
  films: {"at":"/layout/films","kind":"text","title":"films","digits":2,"description":"Directions of the films of each unit: `x`, `y`, or an angle such as `45`."},
  weakest_signal_strain: {"at":"/layout/score/weakest_signal","kind":"float","unit":"1","of_unit":"strain","title":"weakest signal strain","digits":2,"description":"Signal of the film that sees most, strain or volts of a glued one, at the contact angle where that is least."},
  weakest_signal_v: {"at":"/layout/score/weakest_signal","kind":"float","unit":"V","of_unit":"V","title":"weakest signal v","digits":2,"description":"Signal of the film that sees most, strain or volts of a glued one, at the contact angle where that is least."},
  worst_angle_error_deg: {"at":"/layout/score/worst_angle_error_deg","kind":"float","unit":"deg","title":"angle bound","digits":2,"view":"bound","description":"Cramer-Rao bound of the contact angle, worst angle, degrees."},
  rms_angle_error_deg: {"at":"/layout/score/rms_angle_error_deg","kind":"float","unit":"deg","title":"rms angle error deg","digits":2,"description":"Cramer-Rao bound of the contact angle, root mean square over the angles, degrees."},
  worst_depth_error_mm: {"at":"/layout/score/worst_depth_error_mm","kind":"float","unit":"mm","title":"worst depth error mm","digits":2,"description":"Cramer-Rao bound of a uniform depth, worst angle, mm."},
  noise_strain: {"at":"/layout/score/noise_strain","kind":"float","unit":"1","title":"noise strain","digits":2,"description":"Noise of each film assumed for the bounds, strain; null of glued films."},
  noise_v: {"at":"/layout/score/noise_v","kind":"float","unit":"V","title":"noise v","digits":2,"description":"Noise of each glued film assumed for the bounds, V; absent of bare ones."},
  reason: {"at":"/layout/score/reason","kind":"text","title":"reason","digits":2,"description":"Reason why numbers are null."},
  rank_certain: {"at":"/layout/rank_certain","kind":"bool","title":"certain","digits":0,"description":"Whether the errors leave no doubt about its place; absent of one that wasn't ranked."},
  name: {"at":"/layout/name","kind":"text","title":"name","digits":2,"description":"Name of a layout that was listed film by film, or found by the search; absent of a regular one."},
  staggered: {"at":"/layout/staggered","kind":"bool","title":"staggered","digits":2,"description":"Whether the films of a unit are spread evenly between two units."},
  film_count: {"at":"/layout/film_count","kind":"integer","title":"films","digits":0,"view":"ranked","description":"All films of the wheel."},
  bayes_angle_error_deg: {"at":"/layout/score/bayes_angle_error_deg","kind":"float","unit":"deg","title":"bayes angle error deg","digits":2,"description":"Bound of the contact angle's error with a flat prior, root mean square over the angles, degrees: finite where the others aren't."},
  simulated_rms_angle_error_deg: {"at":"/layout/score/simulated_rms_angle_error_deg","kind":"float","unit":"deg","title":"simulated rms angle error deg","digits":2,"description":"Error of the contact angle as estimated from noisy readings, root mean square, degrees."},
  simulated_p95_angle_error_deg: {"at":"/layout/score/simulated_p95_angle_error_deg","kind":"float","unit":"deg","title":"angle, 95 %","digits":2,"error_at":"/layout/score/error/simulated_p95_angle_error_deg","view":"ranked","description":"95 % of simulated contacts are estimated better than this, degrees."},
  simulated_p95_error_deg: {"at":"/layout/score/error/simulated_p95_angle_error_deg","kind":"float","unit":"deg","title":"simulated p95 error deg","digits":2,"description":"Error of the simulated 95th percentile, degrees."},
  lost_share: {"at":"/layout/score/lost_share","kind":"share","unit":"1","title":"lost","digits":1,"view":"ranked","description":"Share of simulated contacts that are off by more than 20 degrees."},
  simulated_rms_depth_error_mm: {"at":"/layout/score/simulated_rms_depth_error_mm","kind":"float","unit":"mm","title":"simulated rms depth error mm","digits":2,"description":"Error of the depth as estimated, root mean square, mm."},
  force_error_n: {"at":"/layout/score/force_error_n","kind":"float","unit":"N","title":"force error n","digits":2,"description":"Error of the depth as a vertical force, N: by the slope of force over depth."},
  alike_sigmas: {"at":"/layout/score/alike/sigmas","kind":"float","unit":"1","title":"most alike, sigmas","digits":1,"view":"alike","description":"Distance of their readings in standard deviations of the noise."},
  worst_angle_mesh_error_deg: {"at":"/layout/score/error/worst_angle_error_deg","kind":"float","unit":"deg","title":"worst angle mesh error deg","digits":2,"description":"Error of the bound of the angle, worst angle, degrees."},
  doubt: {"at":"/layout/doubt","kind":"text","title":"doubt","digits":2,"description":"Figures that may be off by more than a fifth, in words."},
  shear_angle_error_deg: {"at":"/layout/score/shear/worst_angle_error_deg","kind":"float","unit":"deg","title":"angle","digits":2,"error_at":"/layout/score/shear/error/worst_angle_error_deg","view":"shear","description":"Bound of the contact angle, worst angle, degrees."},
  shear_force_x_error_n: {"at":"/layout/score/shear/worst_force_error_n/0","kind":"float","unit":"N","title":"force along","digits":2,"error_at":"/layout/score/shear/error/worst_force_error_n/0","view":"shear","description":"Bounds of the ground's forces on the tire along the wheel, across it (null where no film feels it) and up, worst angle, N."},
  shear_force_y_error_n: {"at":"/layout/score/shear/worst_force_error_n/1","kind":"float","unit":"N","title":"force across","digits":2,"error_at":"/layout/score/shear/error/worst_force_error_n/1","view":"shear","description":"Bounds of the ground's forces on the tire along the wheel, across it (null where no film feels it) and up, worst angle, N."},
  shear_force_z_error_n: {"at":"/layout/score/shear/worst_force_error_n/2","kind":"float","unit":"N","title":"force up","digits":2,"error_at":"/layout/score/shear/error/worst_force_error_n/2","view":"shear","description":"Bounds of the ground's forces on the tire along the wheel, across it (null where no film feels it) and up, worst angle, N."},
  shear_reason: {"at":"/layout/score/shear/reason","kind":"text","title":"shear reason","digits":2,"description":"Quantity that can't be told, in words."},
  dead_p95_angle_error_deg: {"at":"/layout/score/dead/simulated_p95_angle_error_deg","kind":"float","unit":"deg","title":"angle, 95 %, one dead","digits":2,"view":"dead","description":"Simulated 95th percentile of the angle's error without it, degrees."},
  turn_deg: {"at":"/layout/turn_deg","kind":"float","unit":"deg","title":"turn deg","digits":2,"description":"Angle of the first unit from the mark, degrees, where no film may lie there; absent of 0."},
  worst_load_n: {"at":"/layout/worst_load_n","kind":"float","unit":"N","title":"worst load","digits":1,"view":"bound","description":"Load of these scores, N."},
  worst_force_error_n: {"at":"/layout/worst_force/error_n","kind":"float","unit":"N","title":"force, rms","digits":2,"error_at":"/layout/worst_force/claim_n","view":"ranked","description":"The error, root mean square over contacts, N."},
  worst_force_load_n: {"at":"/layout/worst_force/load_n","kind":"float","unit":"N","title":"worst force load n","digits":2,"description":"The load, N."},
} as const;

/** Columns of trade. */
export const TRADE_COLUMNS = {
  film_count: {"at":"/trade/film_count","kind":"integer","title":"films","digits":0,"description":"Number of films."},
  layout: {"at":"/trade/words","kind":"text","title":"layout","digits":2,"description":"Description of the layout, as in `12 films along y at the crown, one every 30 degrees`."},
  angle_error_deg: {"at":"/trade/angle_error_deg","kind":"float","unit":"deg","title":"angle, 95 %","digits":2,"error_at":"/trade/angle_claim_deg","view":"trade","description":"Simulated 95th percentile of the angle's error at its worst load, degrees."},
  angle_claim_deg: {"at":"/trade/angle_claim_deg","kind":"float","unit":"deg","title":"angle claim deg","digits":2,"description":"Claimed error of that, degrees; null where there is no coarser mesh."},
  force_error_n: {"at":"/trade/force_error_n","kind":"float","unit":"N","title":"force, rms","digits":2,"error_at":"/trade/force_claim_n","view":"trade","description":"Root mean square error of the vertical force at the load where that is largest, N."},
  force_claim_n: {"at":"/trade/force_claim_n","kind":"float","unit":"N","title":"force claim n","digits":2,"description":"Claimed error of that, N; null where there is no coarser mesh."},
  cost: {"at":"/trade/cost","kind":"float","unit":"1","title":"cost","digits":2,"description":"Cost of the films that aren't glued on already, and of a channel for each; null where the question tells no costs."},
  meets: {"at":"/trade/meets","kind":"bool","title":"meets","digits":2,"description":"Whether it meets every limit that is asked for; null where none is."},
  is_front: {"at":"/trade/is_front","kind":"bool","title":"is front","digits":2,"description":"Whether fewer films do worse."},
  rank: {"at":"/trade/rank","kind":"integer","title":"rank","digits":2,"description":"Rank of the layout in `layouts`."},
} as const;

/** Columns of films. */
export const FILMS_COLUMNS = {
  film: {"at":"/film/number","kind":"integer","title":"film","digits":2,"description":"Number of the film, from 1, around the wheel from the mark."},
  theta_deg: {"at":"/film/theta_deg","kind":"float","unit":"deg","title":"angle","digits":1,"description":"Wheel angle from the mark in the rolling direction, degrees."},
  arc_mm: {"at":"/film/arc_mm","kind":"float","unit":"mm","title":"arc from the mark","digits":1,"description":"Arc on the inner surface from the mark to the film's middle, around the wheel at its section angle, mm."},
  phi_deg: {"at":"/film/phi_deg","kind":"float","unit":"deg","title":"section","digits":1,"description":"Section angle from the crown, degrees."},
  from_bead_mm: {"at":"/film/from_bead_mm","kind":"float","unit":"mm","title":"from the bead","digits":1,"description":"Arc on the inner surface from the nearer bead, where the wall ends, to the film's middle, mm."},
  from_crown_mm: {"at":"/film/from_crown_mm","kind":"float","unit":"mm","title":"from crown mm","digits":2,"description":"Arc from the crown to the film's middle, negative on the side of negative section angles, mm."},
  direction: {"at":"/film/direction","kind":"text","title":"direction","digits":2,"description":"Direction of its length: `x`, `y`, or an angle such as `45`."},
  length_mm: {"at":"/film/length_mm","kind":"float","unit":"mm","title":"length","digits":1,"description":"Length of the film, mm; null of a point."},
  width_mm: {"at":"/film/width_mm","kind":"float","unit":"mm","title":"width","digits":1,"description":"Width of the film, mm; null of a point."},
  connector_arc_mm: {"at":"/film/connector_arc_mm","kind":"float","unit":"mm","title":"connector arc mm","digits":2,"description":"Arc from the mark to its connector, which is at the end nearer to a bead, and of a film along the wheel at the end ahead, mm."},
  connector_from_bead_mm: {"at":"/film/connector_from_bead_mm","kind":"float","unit":"mm","title":"connector from bead mm","digits":2,"description":"Arc from the nearer bead to its connector, mm."},
  lead_mm: {"at":"/film/lead_mm","kind":"float","unit":"mm","title":"lead","digits":0,"description":"Length of a lead from its connector straight to the bead, and along that to the mark on the shorter way, mm."},
  expected_strain: {"at":"/film/expected_strain","kind":"float","unit":"1","title":"expected strain","digits":2,"description":"Strain that it reads with the contact at it, at the depth below; null of glued films, and where it isn't known."},
  expected_v: {"at":"/film/expected_v","kind":"float","unit":"V","title":"expected v","digits":2,"description":"Open circuit's voltage that a glued film reads so, V; null of bare films."},
  expected_depth_mm: {"at":"/film/expected_depth_mm","kind":"float","unit":"mm","title":"expected depth mm","digits":2,"description":"Depth of that contact: the load in the middle, mm."},
} as const;

/** Columns of candidates. */
export const CANDIDATES_COLUMNS = {
  section_deg: {"at":"/film/section_deg","kind":"float","unit":"deg","title":"section angle","digits":1,"description":"Section angle from the crown, degrees."},
  direction: {"at":"/film/direction","kind":"text","title":"direction","digits":2,"description":"Direction of its length."},
  length_mm: {"at":"/film/length_mm","kind":"float","unit":"mm","title":"length","digits":1,"description":"Length of the film, mm; null of a point."},
  width_mm: {"at":"/film/width_mm","kind":"float","unit":"mm","title":"width","digits":1,"description":"Width of the film, mm; null of a point."},
  signal: {"at":"/film/signal","kind":"float","unit":"1","of_unit":"strain","title":"signal","digits":2,"description":"Largest signal around the wheel, over all loads."},
  signal_v: {"at":"/film/signal","kind":"float","unit":"V","of_unit":"V","title":"signal v","digits":2,"description":"Largest signal around the wheel, over all loads."},
  angle_information: {"at":"/film/angle_information","kind":"float","unit":"1/deg","title":"angle information","digits":2,"description":"Root of the mean information on the contact angle over the turn and the loads, 1/degree, at the noise of the layouts."},
  angle_information_error: {"at":"/film/angle_information_error","kind":"float","unit":"1/deg","title":"angle information error","digits":2,"description":"Error of the information on the angle by the coarser mesh."},
  depth_information: {"at":"/film/depth_information","kind":"float","unit":"1/mm","title":"depth information","digits":2,"description":"Root of the mean information on the depth, 1/mm."},
} as const;

/** Columns of signals. */
export const SIGNALS_COLUMNS = {
  tire: {"at":"/row/tire","kind":"text","title":"tire","digits":2,"description":"Name of the tire; the study's own is `own`."},
  film: {"at":"/row/film","kind":"text","title":"film","digits":2,"description":"Model of the film."},
  position: {"at":"/row/position","kind":"text","title":"position","digits":2,"description":"Position of the film in the section."},
  direction: {"at":"/row/direction","kind":"text","title":"direction","digits":2,"description":"Direction of its length: x circumferential, y meridional."},
  over: {"at":"/row/over","kind":"text","title":"over","digits":2,"description":"Curve that it is a point of."},
  load_n: {"at":"/row/load_n","kind":"float","unit":"N","title":"load n","digits":2,"description":"Vertical force of the ground, N."},
  pressure_mpa: {"at":"/row/pressure_mpa","kind":"float","unit":"MPa","title":"pressure mpa","digits":2,"description":"Internal pressure, MPa."},
  contact_deg: {"at":"/row/contact_deg","kind":"float","unit":"deg","title":"contact deg","digits":2,"description":"Wheel angle from the film to the contact, degrees."},
  depth_mm: {"at":"/row/depth_mm","kind":"float","unit":"mm","title":"depth mm","digits":2,"description":"Height of the ground above the inflated outer radius, mm."},
  strain: {"at":"/row/strain","kind":"float","unit":"1","title":"strain","digits":2,"description":"Mean strain along the film since inflation."},
  tension_1_n_per_mm: {"at":"/row/tension_1_n_per_mm","kind":"float","unit":"N/mm","title":"tension 1 n per mm","digits":2,"description":"Mean tension along the film since inflation, N/mm."},
  charge_nc: {"at":"/row/charge_nc","kind":"float","unit":"nC","title":"charge nc","digits":2,"description":"Charge, nC."},
  open_circuit_v: {"at":"/row/open_circuit_v","kind":"float","unit":"V","title":"open circuit v","digits":2,"description":"Voltage where nothing draws charge, V."},
  output_v: {"at":"/row/output_v","kind":"float","unit":"V","title":"output v","digits":2,"description":"Amplitude at the amplifier, V."},
  output_std_v: {"at":"/row/output_std_v","kind":"float","unit":"V","title":"output std v","digits":2,"description":"Standard deviation of that by noise, gain and temperature, V."},
  state: {"at":"/row/state","kind":"text","title":"state","digits":2,"description":"Whether the film bears that, and the amplifier shows it: `ok`, `beyond-yield`, `saturated` or `wrinkled`; null where that isn't known."},
  strain_error: {"at":"/row/error/strain","kind":"float","unit":"1","title":"strain error","digits":2,"description":"Error of the strain."},
  charge_error_nc: {"at":"/row/error/charge_nc","kind":"float","unit":"nC","title":"charge error nc","digits":2,"description":"Error of the charge, nC."},
  open_circuit_error_v: {"at":"/row/error/open_circuit_v","kind":"float","unit":"V","title":"open circuit error v","digits":2,"description":"Error of the open circuit's voltage, V."},
  output_error_v: {"at":"/row/error/output_v","kind":"float","unit":"V","title":"output error v","digits":2,"description":"Error of the amplifier's voltage, V."},
  reason: {"at":"/row/reason","kind":"text","title":"reason","digits":2,"description":"Reason why numbers are null."},
} as const;

/** Columns of forces. */
export const FORCES_COLUMNS = {
  layout_rank: {"at":"/layout/rank","kind":"integer","title":"rank","digits":0,"description":"1 is best. Layouts of equal score share the rank of the first of them."},
  films: {"at":"/layout/film_count","kind":"integer","title":"films","digits":2,"description":"All films of the wheel."},
  force: {"at":"/force/axis","kind":"text","title":"force","digits":2,"view":"known","description":"`fx`: along the wheel, `fy`: across it, `fz`: vertical."},
  chosen: {"at":"/force/chosen","kind":"text","title":"chosen","digits":2,"description":"The model that is chosen by left-out runs; `mean` where none is better than the training mean."},
  features: {"at":"/force/features","kind":"text","title":"features","digits":2,"description":"The features it reads."},
  useful: {"at":"/force/useful","kind":"bool","title":"useful","digits":2,"description":"Whether its error on left-out runs is at most 95 % of the training mean's."},
  leak: {"at":"/force/leak","kind":"float","unit":"1","title":"leak","digits":2,"view":"leak","description":"Error on left-out runs over that on random rows, both as shares of the training mean's error on the same rows: how far a random split would have misled.\nNull of the training mean."},
  bound_n: {"at":"/force/floor_n","kind":"float","unit":"N","title":"bound","digits":2,"description":"Estimate of the least root of the mean squared error that one instant's readings allow, N: the bound of Cramer and Rao with what is known of the gait\nbefore, for films that hold their charge."},
  fresh_rmse_n: {"at":"/force/fresh/rmse_n","kind":"float","unit":"N","title":"learnt, off by","digits":2,"view":"known","description":"Root of the mean squared error, N."},
  fresh_nrmse_percent: {"at":"/force/fresh/nrmse_percent","kind":"float","unit":"%","title":"NRMSE","digits":1,"view":"known","description":"RMSE over the range of the true forces, %; null where these don't vary."},
  fresh_r2: {"at":"/force/fresh/r2","kind":"float","unit":"1","title":"R2","digits":2,"view":"known","description":"Coefficient of determination; null where the true forces don't vary."},
  fresh_coverage: {"at":"/force/fresh/coverage","kind":"float","unit":"1","title":"covered","digits":2,"view":"known","description":"Share of the true forces within their 95 % intervals."},
  contact_rmse_n: {"at":"/force/in_contact/rmse_n","kind":"float","unit":"N","title":"in contact","digits":2,"view":"known","description":"Root of the mean squared error, N."},
  contact_nrmse_percent: {"at":"/force/in_contact/nrmse_percent","kind":"float","unit":"%","title":"in contact NRMSE","digits":1,"description":"RMSE over the range of the true forces, %; null where these don't vary."},
  contact_r2: {"at":"/force/in_contact/r2","kind":"float","unit":"1","title":"in contact R2","digits":2,"description":"Coefficient of determination; null where the true forces don't vary."},
  contact_coverage: {"at":"/force/in_contact/coverage","kind":"float","unit":"1","title":"in contact covered","digits":2,"description":"Share of the true forces within their 95 % intervals."},
  dead_rmse_n: {"at":"/force/dead/error/rmse_n","kind":"float","unit":"N","title":"one dead","digits":2,"view":"known","description":"Root of the mean squared error, N."},
  dead_nrmse_percent: {"at":"/force/dead/error/nrmse_percent","kind":"float","unit":"%","title":"one dead NRMSE","digits":1,"description":"RMSE over the range of the true forces, %; null where these don't vary."},
  dead_r2: {"at":"/force/dead/error/r2","kind":"float","unit":"1","title":"one dead R2","digits":2,"description":"Coefficient of determination; null where the true forces don't vary."},
  dead_coverage: {"at":"/force/dead/error/coverage","kind":"float","unit":"1","title":"one dead covered","digits":2,"description":"Share of the true forces within their 95 % intervals."},
  askew_rmse_n: {"at":"/force/askew/error/rmse_n","kind":"float","unit":"N","title":"films off","digits":2,"view":"known","description":"Root of the mean squared error, N."},
  askew_nrmse_percent: {"at":"/force/askew/error/nrmse_percent","kind":"float","unit":"%","title":"films off NRMSE","digits":1,"description":"RMSE over the range of the true forces, %; null where these don't vary."},
  askew_r2: {"at":"/force/askew/error/r2","kind":"float","unit":"1","title":"films off R2","digits":2,"description":"Coefficient of determination; null where the true forces don't vary."},
  askew_coverage: {"at":"/force/askew/error/coverage","kind":"float","unit":"1","title":"films off covered","digits":2,"description":"Share of the true forces within their 95 % intervals."},
  left_out_rmse_n: {"at":"/left_out/rmse_n","kind":"float","unit":"N","title":"left out rmse n","digits":2,"description":"Root of the mean squared error, N."},
  left_out_nrmse_percent: {"at":"/left_out/nrmse_percent","kind":"float","unit":"%","title":"left out nrmse percent","digits":2,"description":"RMSE over the range of the tested forces, %."},
  mean_nrmse_percent: {"at":"/left_out/mean_nrmse_percent","kind":"float","unit":"%","title":"mean nrmse percent","digits":2,"description":"NRMSE of the training mean, %."},
  worst_contact_deg: {"at":"/force/worst_contact/deg","kind":"float","unit":"deg","title":"worst contact","digits":1,"view":"where","description":"Middle of five degrees of the wheel."},
  worst_contact_rmse_n: {"at":"/force/worst_contact/rmse_n","kind":"float","unit":"N","title":"off by there","digits":2,"view":"where","description":"Root of the mean squared error of rows with a contact there, N."},
  reason: {"at":"/force/reason","kind":"text","title":"reason","digits":2,"description":"Reason why numbers are null."},
} as const;

/** Columns of elsewhere. */
export const ELSEWHERE_COLUMNS = {
  rmse_n: {"at":"/other/error/rmse_n","kind":"float","unit":"N","title":"off by","digits":2,"view":"other tires","description":"Root of the mean squared error, N."},
  own_rmse_n: {"at":"/force/fresh/rmse_n","kind":"float","unit":"N","title":"on its own tire","digits":2,"view":"other tires","description":"Root of the mean squared error, N."},
  coverage: {"at":"/other/error/coverage","kind":"share","unit":"1","title":"covered","digits":0,"view":"other tires","description":"Share of the true forces within their 95 % intervals."},
  outside: {"at":"/other/error/outside","kind":"share","unit":"1","title":"flagged","digits":0,"view":"other tires","description":"Share of the rows that are flagged: one of their signals is beyond what was learnt from."},
} as const;

/** Columns of drifts. */
export const DRIFTS_COLUMNS = {
  rmse_n: {"at":"/drift/error/rmse_n","kind":"float","unit":"N","title":"off by","digits":2,"view":"drift","description":"Root of the mean squared error, N."},
  nrmse_percent: {"at":"/drift/error/nrmse_percent","kind":"float","unit":"%","title":"NRMSE","digits":1,"view":"drift","description":"RMSE over the range of the true forces, %; null where these don't vary."},
  in_contact: {"at":"/drift/in_contact/rmse_n","kind":"float","unit":"1","title":"in contact","digits":2,"view":"drift","description":"Root of the mean squared error, N."},
} as const;

/** Columns of models. */
export const MODELS_COLUMNS = {
  force: {"at":"/force/force","kind":"text","title":"force","digits":2,"description":"Column of the force."},
  model: {"at":"/model/model","kind":"text","title":"model","digits":2,"description":"The model."},
  features: {"at":"/model/features","kind":"text","title":"features","digits":2,"description":"The features it reads."},
  chosen: {"at":"/chosen","kind":"bool","title":"chosen","digits":2,"description":"Whether it estimates the force."},
  by: {"at":"/model/validation/by","kind":"text","title":"by","digits":2,"description":"The split."},
  rmse_n: {"at":"/model/validation/rmse_n","kind":"float","unit":"N","title":"RMSE","digits":3,"view":"judged","description":"Root of the mean squared error, N."},
  nrmse_percent: {"at":"/model/validation/nrmse_percent","kind":"float","unit":"%","title":"NRMSE","digits":2,"view":"judged","description":"RMSE over the range of the tested forces, %."},
  mean_nrmse_percent: {"at":"/model/validation/mean_nrmse_percent","kind":"float","unit":"%","title":"mean's NRMSE","digits":2,"view":"judged","description":"NRMSE of the training mean, %."},
  r2: {"at":"/model/validation/r2","kind":"float","unit":"1","title":"R2","digits":3,"view":"judged","description":"Coefficient of determination."},
  coverage: {"at":"/model/validation/coverage","kind":"float","unit":"1","title":"covered","digits":2,"view":"judged","description":"Share of tested rows within their 95 % intervals, whose width was learnt from other groups."},
  width_n: {"at":"/model/validation/width_n","kind":"float","unit":"N","title":"width","digits":3,"view":"judged","description":"Mean width of these intervals, N."},
  rmse_low_n: {"at":"/model/validation/rmse_interval_n/0","kind":"float","unit":"N","title":"rmse low n","digits":2,"description":"95 % of the bootstrap's samples of whole cycles, N."},
  rmse_high_n: {"at":"/model/validation/rmse_interval_n/1","kind":"float","unit":"N","title":"rmse high n","digits":2,"description":"95 % of the bootstrap's samples of whole cycles, N."},
  random_rmse_n: {"at":"/model/splits/random/rmse_n","kind":"float","unit":"N","title":"random rows","digits":3,"view":"splits","description":"Root of the mean squared error, N."},
  cycle_rmse_n: {"at":"/model/splits/cycle/rmse_n","kind":"float","unit":"N","title":"cycles","digits":3,"view":"splits","description":"Root of the mean squared error, N."},
  run_rmse_n: {"at":"/model/splits/run/rmse_n","kind":"float","unit":"N","title":"runs","digits":3,"view":"splits","description":"Root of the mean squared error, N."},
  time_rmse_n: {"at":"/model/splits/time/rmse_n","kind":"float","unit":"N","title":"later rows","digits":3,"view":"splits","description":"Root of the mean squared error, N."},
  frequency_rmse_n: {"at":"/model/splits/frequency/rmse_n","kind":"float","unit":"N","title":"frequencies","digits":3,"view":"splits","description":"Root of the mean squared error, N."},
  leak_factor: {"at":"/model/leak_factor","kind":"float","unit":"1","title":"leak","digits":2,"view":"leak","description":"RMSE on the strictest split over that on the random one: how far a random split would have misled."},
  better_than_mean: {"at":"/model/better_than_mean","kind":"bool","title":"better than mean","digits":2,"description":"Whether its error is at most 95 % of the training mean's on the split that chooses."},
} as const;

/** Columns of compared locations. */
export const COMPARED_LOCATIONS_COLUMNS = {
  location: {"at":"/row/location","kind":"text","title":"location","digits":2,"description":"P1, P2, ..."},
  rank: {"at":"/row/rank","kind":"integer","title":"rank","digits":2,"description":"1 is best."},
  rank_certain: {"at":"/row/rank_certain","kind":"bool","title":"rank certain","digits":2,"description":"Whether the errors leave no doubt about this rank."},
  rank_change: {"at":"/row/rank_change","kind":"integer","title":"rank change","digits":2,"description":"Places lost since the baseline, negative when gained, where equal locations share the place of the first of them; null there, and where\nit hasn't the location."},
  rank_verdict: {"at":"/row/rank_verdict","kind":"text","title":"rank verdict","digits":2,"description":"A location in one of the studies."},
  gsi_percent_x: {"at":"/row/x/gsi_percent","kind":"float","unit":"%","title":"gsi percent x","digits":2,"description":"The index, percent."},
  error_percent_x: {"at":"/row/x/error_percent","kind":"float","unit":"%","title":"error percent x","digits":2,"description":"Error of the index, percentage points."},
  difference_percent_x: {"at":"/row/x/difference_percent","kind":"float","unit":"%","title":"difference percent x","digits":2,"description":"The index minus the baseline's, percentage points; null in the baseline."},
  difference_error_percent_x: {"at":"/row/x/difference_error_percent","kind":"float","unit":"%","title":"difference error percent x","digits":2,"description":"Error of the difference, percentage points: less than both errors together, where both meshes err alike."},
  verdict_x: {"at":"/row/x/verdict","kind":"text","title":"verdict x","digits":2,"description":"First-order index of the location's own depth for the x strain at the contact centre."},
  gsi_percent_y: {"at":"/row/y/gsi_percent","kind":"float","unit":"%","title":"gsi percent y","digits":2,"description":"The index, percent."},
  error_percent_y: {"at":"/row/y/error_percent","kind":"float","unit":"%","title":"error percent y","digits":2,"description":"Error of the index, percentage points."},
  difference_percent_y: {"at":"/row/y/difference_percent","kind":"float","unit":"%","title":"difference percent y","digits":2,"description":"The index minus the baseline's, percentage points; null in the baseline."},
  difference_error_percent_y: {"at":"/row/y/difference_error_percent","kind":"float","unit":"%","title":"difference error percent y","digits":2,"description":"Error of the difference, percentage points: less than both errors together, where both meshes err alike."},
  verdict_y: {"at":"/row/y/verdict","kind":"text","title":"verdict y","digits":2,"description":"First-order index of the location's own depth for the y strain at the contact centre."},
  spec_sha256: {"at":"/study/spec_sha256","kind":"text","title":"spec sha256","digits":2,"description":"SHA-256 of its document."},
  version: {"at":"/study/version","kind":"text","title":"version","digits":2,"description":"Versions of the program and the solver."},
  baseline: {"at":"/comparison/baseline","kind":"text","title":"baseline","digits":2,"description":"The study that differences are taken from; null when none of them has a result."},
} as const;

/** Columns of designs. */
export const DESIGNS_COLUMNS = {
  state: {"at":"/study/state","kind":"text","title":"state","digits":2,"description":"`queued`, `running`, `done`, `failed` or `cancelled`."},
  reason: {"at":"/study/reason","kind":"text","title":"reason","digits":2,"description":"Reason why there is no result."},
  answer_rank: {"at":"/study/answer/rank","kind":"integer","title":"answer rank","digits":2,"description":"Place among the studies, 1 is best."},
  layout: {"at":"/study/answer/words","kind":"text","title":"layout","digits":2,"description":"Description of the layout, as in `12 films along y at the crown, one every 30 degrees`."},
  film_count: {"at":"/study/answer/film_count","kind":"integer","title":"film count","digits":2,"description":"All its films."},
  meets: {"at":"/study/answer/meets","kind":"bool","title":"meets","digits":2,"description":"Whether it keeps to the limits that the document asks for; null where it asks for none."},
  angle_error_deg: {"at":"/study/answer/angle_deg/value","kind":"float","unit":"deg","title":"angle","digits":2,"error_at":"/study/answer/angle_deg/error","view":"answers","description":"The figure."},
  angle_claim_deg: {"at":"/study/answer/angle_deg/error","kind":"float","unit":"deg","title":"angle claim deg","digits":2,"description":"Claimed error of the figure; null where there is no coarser mesh."},
  angle_difference_deg: {"at":"/study/answer/angle_deg/difference","kind":"float","unit":"deg","title":"angle, difference","digits":2,"error_at":"/study/answer/angle_deg/difference_error","view":"answers","description":"The figure minus the baseline's; null in the baseline."},
  angle_difference_error_deg: {"at":"/study/answer/angle_deg/difference_error","kind":"float","unit":"deg","title":"angle difference error deg","digits":2,"description":"Error of the difference; null where one of both isn't known."},
  angle_verdict: {"at":"/study/answer/angle_deg/verdict","kind":"text","title":"angle verdict","digits":2,"description":"Error of the contact angle in 95 of 100 contacts at the worst load, degrees."},
  force_error_n: {"at":"/study/answer/force_n/value","kind":"float","unit":"N","title":"force","digits":2,"error_at":"/study/answer/force_n/error","view":"answers","description":"The figure."},
  force_claim_n: {"at":"/study/answer/force_n/error","kind":"float","unit":"N","title":"force claim n","digits":2,"description":"Claimed error of the figure; null where there is no coarser mesh."},
  force_difference_n: {"at":"/study/answer/force_n/difference","kind":"float","unit":"N","title":"force, difference","digits":2,"error_at":"/study/answer/force_n/difference_error","view":"answers","description":"The figure minus the baseline's; null in the baseline."},
  force_difference_error_n: {"at":"/study/answer/force_n/difference_error","kind":"float","unit":"N","title":"force difference error n","digits":2,"description":"Error of the difference; null where one of both isn't known."},
  force_verdict: {"at":"/study/answer/force_n/verdict","kind":"text","title":"force verdict","digits":2,"description":"A study of those compared."},
  layout_verdict: {"at":"/study/answer/verdict","kind":"text","title":"certainty","digits":0,"view":"answers","description":"Certainty of the layout within its study."},
  level: {"at":"/study/level","kind":"text","title":"level","digits":2,"description":"Mesh level."},
  reaction_n: {"at":"/study/reaction_n","kind":"float","unit":"N","title":"reaction n","digits":2,"description":"Vertical force at the means, N."},
  std_strain_x: {"at":"/study/std_strain_x","kind":"float","unit":"1","title":"std strain x","digits":2,"description":"Standard deviation of the x strain at the contact centre: the signal of a film there."},
  std_strain_y: {"at":"/study/std_strain_y","kind":"float","unit":"1","title":"std strain y","digits":2,"description":"Standard deviation of the y strain there."},
  best: {"at":"/study/best","kind":"text","title":"best","digits":2,"description":"First of the ranking."},
  best_certain: {"at":"/study/best_certain","kind":"bool","title":"best certain","digits":2,"description":"Whether its errors leave no doubt about that."},
  layout_spacing_deg: {"at":"/study/layout_spacing_deg","kind":"float","unit":"deg","title":"layout spacing deg","digits":2,"description":"Angle between the units of that layout, degrees."},
  layout_position: {"at":"/study/layout_position","kind":"text","title":"layout position","digits":2,"description":"Position of that layout's units."},
  solves: {"at":"/study/cost/solves","kind":"integer","title":"solves","digits":2,"description":"Points of the plan."},
  coarser_solves: {"at":"/study/cost/coarser_solves","kind":"integer","title":"coarser solves","digits":2,"description":"Points of the plan solved once more on a coarser mesh, for the error of the mesh."},
  effect_solves: {"at":"/study/cost/effect_solves","kind":"integer","title":"effect solves","digits":2,"description":"Solves that show what the model leaves out."},
  reused: {"at":"/study/cost/reused","kind":"integer","title":"reused","digits":2,"description":"Points taken from the archive instead of being solved."},
  wall_s: {"at":"/study/cost/wall_s","kind":"float","unit":"s","title":"wall s","digits":2,"description":"Wall-clock time of this run, s."},
  cpu_s: {"at":"/study/cost/cpu_s","kind":"float","unit":"s","title":"cpu s","digits":2,"description":"Processor time of this run's own threads, s; 0 where the system doesn't tell it."},
  spec_sha256: {"at":"/study/spec_sha256","kind":"text","title":"spec sha256","digits":2,"description":"SHA-256 of its document."},
  version: {"at":"/study/version","kind":"text","title":"version","digits":2,"description":"Versions of the program and the solver."},
  baseline: {"at":"/comparison/baseline","kind":"text","title":"baseline","digits":2,"description":"The study that differences are taken from; null when none of them has a result."},
} as const;

/** Columns of rungs. */
export const RUNGS_COLUMNS = {
  label: {"at":"/rung/label","kind":"text","title":"label","digits":2,"description":"Label in a few words."},
  level: {"at":"/rung/fidelity/level","kind":"text","title":"level","digits":2,"description":"Mesh level."},
  method: {"at":"/rung/fidelity/method","kind":"text","title":"method","digits":2,"description":"Method."},
  nodes: {"at":"/rung/fidelity/nodes","kind":"integer","title":"nodes","digits":2,"description":"Gauss nodes for each input, at the start where the method adds some."},
  check_points: {"at":"/rung/fidelity/check_points","kind":"integer","title":"check points","digits":2,"description":"Points off the lines, at the start where the method adds some."},
  wall_s: {"at":"/rung/wall_s","kind":"float","unit":"s","title":"wall","digits":2,"view":"rungs","description":"Wall-clock time, s."},
  cpu_s: {"at":"/rung/cpu_s","kind":"float","unit":"s","title":"CPU","digits":2,"view":"rungs","description":"Processor time, s."},
  solves: {"at":"/rung/solves","kind":"integer","title":"solves","digits":0,"view":"rungs","description":"Solves, those on the coarser mesh included."},
  error_true: {"at":"/rung/error_true","kind":"float","unit":"1","title":"largest error","digits":4,"view":"rungs","description":"Largest error of an index that the ranking goes by, absolute; null where an index is missing."},
  error_claimed: {"at":"/rung/error_claimed","kind":"float","unit":"1","title":"claimed error","digits":4,"view":"rungs","description":"The largest that the rung claims."},
  covered: {"at":"/rung/covered","kind":"share","unit":"1","title":"claims that hold","digits":0,"view":"rungs","description":"Share of the indices whose claimed error covers the true one; null where nothing is claimed."},
  ranking_agrees: {"at":"/rung/ranking_agrees","kind":"bool","title":"ranking agrees","digits":2,"description":"Whether the locations rank as by the reference, where that one's own errors leave no doubt which of two is better."},
  pareto: {"at":"/rung/pareto","kind":"bool","title":"pareto","digits":2,"description":"Whether no other rung is both faster and nearer to the reference."},
} as const;
