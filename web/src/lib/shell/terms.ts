/** What the page's terms mean, in one or two sentences each. */

export const TERMS = {
  "first-order index": "The share of a strain's variance that goes when one input alone is held fixed, 0 to 100 %. Also Sobol index or main effect.",
  "total index": "The share of a strain's variance in which an input takes part at all, alone or together with others. Never below its first-order index.",
  gsi: "Global sensitivity index: 100 times the first-order index of the contact depth at a place. Places are ranked by it.",
  "cut point": "The point at which all inputs have their mean values. The study's lines of solves all pass through it.",
  "M-DRM":
    "Multiplicative dimensional reduction: the strain as a product of functions of one input each, so that few solves suffice. It fails where a factor changes its sign.",
  "decomposition error": "What is lost by taking the strain as made of functions of one input each, judged by solves off the lines through the cut point.",
  "quadrature error": "What is lost by averaging over an input at few nodes.",
  "mesh error": "What is lost by a mesh of finite size, judged by the same study on a coarser one.",
  crown: "The middle of the tread, opposite the ground: 0° across the section.",
  shoulder: "Where tread and sidewall meet: 45° from the crown across the section.",
  sidewall: "The side of the tire: 90° from the crown across the section.",
  bead: "Where the wall ends and is held by the rim.",
  "x and y": "x is circumferential, along the rolling direction; y is meridional, across the section from bead to bead. Both lie on the inner surface.",
  "θ and φ": "θ is the angle around the wheel from the middle of the contact, φ the angle across the section from the crown.",
  µε: "Microstrain: a change of length by a millionth. 10 000 µε are 1 %.",
  certain: "The errors leave no doubt.",
  likely: "The next is farther off than either error, but not than both together.",
  tied: "The errors can't tell it from others.",
  unknown: "An error is missing, or the contact is lost.",
  "95 % of contacts":
    "Contacts at random angles and depths are simulated with noise on the films, and found again from their readings. 95 % of them are off by no more than this.",
  "lost share": "The share of simulated contacts whose angle is found wrong by more than 20°: another contact gave nearly the same readings.",
  "Cramér–Rao bound":
    "The smallest error that any unbiased reckoning from the films' readings could have near the true angle. It sees no mistaken contacts far away.",
  "true error": "The largest difference of an index from that of the finest answer in the trade.",
  "claimed error": "The error that an answer states of itself, before a finer one is known.",
  "real difference": "A difference from the baseline that is larger than its own error.",
  "film signal": "The open circuit volts of a piezoelectric film, from the strain averaged over its area.",
  "training mean": "The mean of the forces that were learnt from, given for every row. A model that isn't 5 % better than that is useless.",
  blend:
    "The median of the models whose errors are within 1.2 times the least on what was left out, two of a kind at most: so few runs can't tell which of them the next one will like best.",
  "95 % interval": "From low to high around an estimate: 95 % of rows that weren't learnt from lay within theirs, with widths learnt from others.",
  "leak factor": "The error on runs or cycles left out over that on rows drawn at random, whose neighbours were learnt from.",
} as const;

export type TermName = keyof typeof TERMS;
