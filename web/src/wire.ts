// Made from openapi.json by `npm run wire`; not edited by hand.

export type paths = Record<string, never>;
export type webhooks = Record<string, never>;
export interface components {
    schemas: {
        /** @description What is asked of the answer: one of the three. */
        AccuracyDocument: {
            /** @description Level of the mesh: draft, coarse, standard or reference. */
            preset?: string;
            /**
             * Format: double
             * @description Largest error of any first-order index, absolute.
             */
            tolerance?: number;
            /**
             * Format: double
             * @description Wall-clock time, s.
             */
            budget_s?: number;
        };
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
        /** @description Where the films go, how sure that is, and what could overturn it. */
        Answer: {
            /** @description The answer: the best layout and what it knows, or the best place where no layouts are asked for. */
            sentence: string;
            /** @description The weaker of the verdicts on place and layout. */
            verdict: components["schemas"]["Certainty"];
            /** @description Why it isn't surer, or why it is certain, with the figures that decide; whole sentences. */
            reason: string;
            place?: components["schemas"]["PlaceAnswer"] | null;
            layout?: components["schemas"]["LayoutAnswer"] | null;
            left_out?: components["schemas"]["LeftOut"] | null;
            surer?: components["schemas"]["Surer"] | null;
        };
        /** @description With films askew. */
        AskewError: {
            /**
             * Format: double
             * @description Standard deviation of the films' places around the wheel, degrees.
             */
            std_deg: number;
            /** @description What estimates are worth then. */
            error: components["schemas"]["TrialError"];
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
             * @description Its length, mm; null of a point.
             */
            length_mm?: number | null;
            /**
             * Format: double
             * @description Its width, mm; null of a point.
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
             * @description Effective independence: its share in what all candidates together tell apart, 0 to 1.
             */
            effective_independence: number;
            /** @description Its place among those that pivoting picks, 1 first; null of those that add nothing. */
            pivot_rank?: number | null;
            /**
             * Format: double
             * @description Standard deviation of the signal at the contact's centre over the depths of the study: what the paper ranks by.
             */
            centre_std: number;
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
            /** @description How far each two criteria order them alike. */
            agreement: components["schemas"]["OrderAgreement"][];
        };
        /** @description Where films may go. */
        CandidatesDocument: {
            /** @description `P1-P5` */
            points?: string;
            /** @description `["x"]`, `["y"]` or both. */
            directions?: string[];
            /** @description `circumferential` and `meridional` numbers of points of the dense map, and `half_width_deg`. */
            grid: Record<string, unknown>;
        };
        /**
         * @description How sure a first rank is, by what the order goes by; surest first. Mirror images tie by symmetry: that isn't uncertainty.
         * @enum {string}
         */
        Certainty: "certain" | "likely" | "tied" | "unknown";
        /** @description One modelling choice with its reason. */
        Choice: {
            /** @description The part. */
            what: string;
            /** @description The reason. */
            why: string;
            /**
             * Format: double
             * @description What leaving it out does: the largest change of a strain at P1, P2, ... at the means when it is modelled, over the largest strain
             *     of that direction there. 0 where leaving it out is exact; absent where the part is modelled, or the effect isn't known.
             */
            effect?: number | null;
        };
        /**
         * @description What is claimed of films' voltages.
         * @enum {string}
         */
        Claim: "voltage rises with load" | "voltage falls with pressure" | "linear over the contact angle";
        /** @description Whether a claim holds of one film. */
        ClaimRow: {
            /** @description Name of the tire. */
            tire: string;
            /** @description How the film is modelled. */
            film: components["schemas"]["FilmModel"];
            /** @description Where it lies in the section. */
            position: string;
            /** @description Direction of its length. */
            direction: string;
            /** @description What is claimed. */
            claim: components["schemas"]["Claim"];
            /** @description Whether it holds. */
            holds: components["schemas"]["Holds"];
            /** @description What the curve does. */
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
            /** @description What was tried, in order; the answer is the last one's. */
            rungs: components["schemas"]["ClimbRung"][];
        };
        /** @description One step of the way. */
        ClimbRung: {
            /** @description In a few words. */
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
             * @description What the finer mesh may be off, over its difference from the coarser one.
             */
            factor: number;
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
             * @description Its error, percentage points.
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
        /** @description One of the studies. */
        ComparedStudy: {
            /** @description Its identifier. */
            id: string;
            /** @description Its name, or that of the design. */
            name: string;
            /** @description What the design sets, by path; null for a study that belongs to no sweep. */
            set?: Record<string, unknown> | null;
            /** @description `queued`, `running`, `done`, `failed` or `cancelled`. */
            state: string;
            /** @description Why there is no result. */
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
            /**
             * Format: double
             * @description Angle between the units of the best layout, degrees.
             */
            layout_spacing_deg?: number | null;
            /** @description Where they lie. */
            layout_position?: string | null;
            cost?: components["schemas"]["StudyCost"] | null;
        };
        /** @description The table. */
        Comparison: {
            /** @description The study that differences are taken from; null when none of them has a result. */
            baseline?: string | null;
            /** @description The studies in the order asked for. */
            studies: components["schemas"]["ComparedStudy"][];
            /** @description Every location of every study that has a result, best first. */
            rows: components["schemas"]["ComparedLocation"][];
            /** @description What the reader must know before believing the differences, whole sentences. */
            notes: string[];
        };
        /**
         * @description How a comparison is written.
         * @enum {string}
         */
        ComparisonFormat: "csv" | "json" | "parquet";
        /**
         * @description What is wanted of a comparison.
         * @enum {string}
         */
        ComparisonTable: "locations" | "designs";
        /** @description A figure that can't be true beside the others. */
        Contradiction: {
            /** @description Which figure: `r2`, `nrmse_percent`, or `both` where two cells contradict each other and none tells which is right. */
            figure: string;
            /**
             * Format: double
             * @description What the other cells and this one's RMSE imply; null where none tells.
             */
            implied?: number | null;
            /** @description A sentence. */
            detail: string;
        };
        /** @description A number of solves with its range. */
        CountForecast: {
            /** @description At least. */
            least: number;
            /** @description As far as can be told. */
            expected: number;
            /** @description At most. */
            most: number;
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
             * @description How far the ground at the contact centre stands above the inflated outer radius, mm; absent from results of earlier versions.
             */
            depth_mm?: number | null;
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
        /** @description What is left when a film dies. */
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
        /** @description With a film dead. */
        DeadFilmError: {
            /** @description The film, counted from 0. */
            film: number;
            /** @description What estimates are worth without it. */
            error: components["schemas"]["TrialError"];
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
        /** @description One design. */
        DesignDocument: {
            /** @description What it sets when left out, as `wall_mm = 2.5`. */
            name?: string;
            /** @description Values by path: `geometry.wall_mm` for the scene's fields, `method.nodes` for the study's own. */
            set: Record<string, unknown>;
        };
        /** @description What a design would cost. */
        DesignEstimate: {
            /** @description What tells it from the others. */
            name: string;
            /** @description Its estimate. */
            estimate: components["schemas"]["Estimate"];
        };
        /** @description One of the designs. */
        DesignView: {
            /**
             * Format: int64
             * @description Its place.
             */
            ordinal: number;
            /** @description What tells it from the others. */
            name: string;
            /** @description Values by path. */
            set: Record<string, unknown>;
            /** @description The study that answers for it. */
            study: components["schemas"]["StudySummary"];
        };
        /** @description On another tire. */
        ElsewhereError: {
            /** @description In what it differs from the study's. */
            tire: string;
            /** @description Whether estimators learnt from runs on it, too. */
            learnt?: boolean;
            /** @description What estimates are worth there. */
            error: components["schemas"]["TrialError"];
        };
        /** @description What lists say of a study or a sweep: `name`, `archived` or both. What is left out stays as it is. */
        EntryChange: {
            /** @description Another name. The document, its hash and the result keep the one that was submitted. */
            name?: string;
            /** @description Whether lists leave it out. */
            archived?: boolean;
        };
        /** @description What a study is expected to cost, and to be worth. */
        Estimate: {
            /** @description Equilibria to solve. */
            solves: components["schemas"]["SolveForecast"];
            wall_s?: components["schemas"]["Forecast"] | null;
            /**
             * Format: int64
             * @description Largest resident memory of the process, bytes.
             */
            peak_memory_bytes: number;
            /** @description What the answer is expected to be worth. */
            accuracy: components["schemas"]["ExpectedAccuracy"];
            /** @description Solves at once. */
            threads: number;
            /** @description Solves of this database by which the times were corrected for this machine; 0: the times are those of another machine. */
            measured_solves: number;
            /** @description Why figures are ranges or null, whole sentences. */
            reasons: string[];
        };
        /** @description An estimator with its recipe. */
        EstimatorDetail: components["schemas"]["EstimatorSummary"] & {
            /** @description The recipe as it was submitted. */
            recipe: Record<string, unknown>;
        };
        /** @description Recordings to learn forces from, and how. */
        EstimatorDocument: {
            /** @description Free text; the first recording's file where it is left out. */
            name?: string;
            /**
             * @description What is to be done, as in a recipe of `strainsite force fit`: the tables `columns`, `preprocess`, `features`, `models` and `validation`, every field with a
             *     default.
             */
            recipe?: Record<string, unknown>;
            /** @description One a run. */
            recordings: components["schemas"]["RecordingDocument"][];
        };
        /** @description One page of estimators, newest first. */
        EstimatorPage: {
            /** @description The estimators. */
            estimators: components["schemas"]["EstimatorSummary"][];
            /** @description Where the next page begins; null on the last one. */
            next_cursor?: string | null;
        };
        /** @description An estimator in its queue, at work, or at its end. Times are RFC 3339, UTC. */
        EstimatorSummary: {
            /** @description UUID, ordered by time. */
            id: string;
            /** @description Free text. */
            name: string;
            /** @description Where it stands. */
            state: components["schemas"]["State"];
            /** @description Why it failed, a sentence. */
            error?: string | null;
            /** @description When it was submitted. */
            created: string;
            /** @description When it was first started. */
            started?: string | null;
            /** @description When it ended. */
            finished?: string | null;
            /** @description The forces' columns, N. */
            forces: string[];
            /** @description What it is learnt from. */
            recordings: components["schemas"]["RecordingFigures"][];
            progress?: components["schemas"]["FitProgress"] | null;
        };
        /** @description One point that has an outcome. */
        EvaluationView: {
            /** @description Its place. */
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
             * @description How far the ground at the contact centre stands above the inflated outer radius, mm; absent without an equilibrium.
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
            /** @description Why there is no equilibrium. */
            reason?: string | null;
            reached?: components["schemas"]["Reached"] | null;
        };
        /** @description Solved points. */
        Evaluations: {
            /** @description In the order of the plan; those after it are the same on a coarser mesh, or on the next rung of a climb. */
            evaluations: components["schemas"]["EvaluationView"][];
        };
        /** @description What studies of this kind were worth where that was measured: the largest error of the ten indices that the paper's study ranks by, absolute. */
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
             * @description What the answer claimed itself.
             */
            error_claimed?: number | null;
            /** @description Why there are no figures. */
            reason?: string | null;
        };
        /** @description A node without an equilibrium. */
        FailedNode: {
            /**
             * Format: double
             * @description Value of the input.
             */
            value: number;
            /** @description Why, a sentence. */
            reason: string;
        };
        /** @description A point without a response. */
        FailedPoint: {
            /** @description Ordinal in the plan. */
            ordinal: number;
            /** @description Input values. */
            values: number[];
            /** @description What happened. */
            cause: string;
        };
        /** @description One fault of a document: where it is, and what would be right. */
        Fault: {
            /** @description JSON pointer (RFC 6901) to the faulty value; empty for the document itself. */
            pointer: string;
            /** @description What is wrong and what would be right, one sentence. */
            detail: string;
        };
        /**
         * @description A set of features (the ablations of the paper's tables 4 and 5), in the order of their sizes.
         * @enum {string}
         */
        FeatureSet: "raw" | "slopes" | "rolling" | "all";
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
        /** @description What films read at one load. */
        FieldLoad: {
            /**
             * Format: double
             * @description How far the ground stands above the inflated outer radius, mm.
             */
            depth_mm: number;
            /**
             * Format: double
             * @description Vertical force, N.
             */
            load_n?: number | null;
            /**
             * Format: double
             * @description Its derivative by the depth, N/mm.
             */
            force_slope_n_per_mm: number;
            /** @description Signal of each kind: a sample for each degree from the contact to the film, from -180 on. */
            signals: number[][];
            /** @description Its derivative by the depth, per mm: as many samples. */
            slopes_per_mm: number[][];
        };
        /**
         * @description How a file is written.
         * @enum {string}
         */
        FileFormat: "csv" | "json" | "parquet" | "vtu" | "glb";
        /** @description Glued films solved with the tire around the wheel, in a table on undragged ground; errors are over the largest signal of their kind. */
        FilmAnglesReport: {
            /** @description Mesh level of the tire with a film. */
            level: string;
            /** @description Angles from the contact, degrees; films that lie askew on both sides of it. */
            angles_deg: number[];
            /** @description Loads, N. */
            loads_n: number[];
            /** @description Solves between them that tested the table; 0 where it isn't tested, or where one of them has no equilibrium. */
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
             * @description The largest error that a transfer without this axis would have.
             */
            transfer_worst: number;
        };
        /** @description Signals of every kind of film at every load of a study's layouts. */
        FilmFields: {
            /** @description What signals are in: `strain`, or `V` of glued films. */
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
        /** @description Where in the section a film lies, and how it is turned. */
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
         * @description How a film is modelled.
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
            /** @description How the films are modelled. */
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
        /** @description What a fit took. */
        FitCost: {
            /** @description Candidates that were judged, of all forces. */
            candidates: number;
            /**
             * Format: double
             * @description Wall clock, s.
             */
            wall_s: number;
        };
        /** @description How far a fit is. */
        FitProgress: {
            /** @description Models judged. */
            done: number;
            /** @description Of how many; 0 until that is known. */
            of: number;
        };
        /** @description How well a layout's films tell one force, by an estimator that is learnt from runs of a virtual rig. */
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
            /** @description On runs that nobody learnt from: films have other gains there. */
            fresh: components["schemas"]["TrialError"];
            dead?: components["schemas"]["DeadFilmError"] | null;
            /** @description The same with films that lie elsewhere than those that were learnt from. */
            askew: components["schemas"]["AskewError"];
            /** @description The same films on other tires. */
            elsewhere?: components["schemas"]["ElsewhereError"][];
            worst_contact?: components["schemas"]["WorstContact"] | null;
            /**
             * Format: double
             * @description About the least root of the mean squared error that one instant's readings allow, N: the bound of Cramer and Rao with what is known of the gait before, for films
             *     that hold their charge.
             */
            floor_n?: number | null;
            /** @description Why numbers are null. */
            reason?: string | null;
        };
        /** @description What a virtual rig shows. */
        ForceFindings: {
            table?: components["schemas"]["TableReport"] | null;
            /** @description What a force's error costs: for each force the layouts by which it is known better than by any with as many films or fewer. */
            price?: components["schemas"]["ForcePrice"][];
            published?: components["schemas"]["PublishedTables"] | null;
            /** @description What is assumed of the rig and stated by no source, whole sentences; empty where nothing was learnt. */
            assumed?: string[];
            /** @description Why something is missing, whole sentences. */
            reasons?: string[];
        };
        /** @description A layout that knows a force better than all that have as many films or fewer. */
        ForcePrice: {
            /** @description `fx`: along the wheel, `fy`: across it, `fz`: vertical. */
            axis: string;
            /** @description How many films the layout has. */
            films: number;
            /**
             * Format: double
             * @description Root of the mean squared error on runs that nobody learnt from, N.
             */
            rmse_n: number;
            /** @description The layout's rank. */
            layout_rank: number;
        };
        /** @description What was found of a force. */
        ForceReport: {
            /** @description Its column. */
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
            /** @description All candidates, the chosen one first, then by their error. */
            models: components["schemas"]["ModelReport"][];
        };
        /** @description A figure with its range. */
        Forecast: {
            /**
             * Format: double
             * @description At least.
             */
            least: number;
            /**
             * Format: double
             * @description As far as can be told.
             */
            expected: number;
            /**
             * Format: double
             * @description At most.
             */
            most: number;
        };
        /** @description What a form misses at the check points: the witness of the method's error, and of how much of it two studies share. */
        FormMisses: {
            /** @description Which node of its input's rule each coordinate of each check point is, point after point. */
            nodes: number[];
            /** @description Strain minus the form's at each check point, over the standard deviation. */
            residuals: number[];
            /** @description What each of them adds to the error of a first-order index, input after input. */
            contributions: number[];
            /**
             * Format: double
             * @description Probability of the interactions, which the residuals stand for.
             */
            weight: number;
            /** @description How many numbers of the form were fitted to the check points. */
            fitted: number;
            /**
             * @description Of each check point, which one is its mirror image, whose strains are its own from the other end; absent where contact or inputs aren't
             *     symmetric.
             */
            images?: number[];
        };
        /** @description A layout that no other beats with as few films. */
        FrontLayout: {
            /** @description Its films. */
            film_count: number;
            /**
             * Format: double
             * @description Simulated 95th percentile of the angle's error at its worst load, degrees.
             */
            simulated_p95_angle_error_deg: number;
            /** @description Where it stands in the list of layouts, from 0. */
            index: number;
        };
        /** @description Further designs of a sweep: `grid` or `designs`. */
        FurtherDesigns: {
            /** @description Lists of values by path. */
            grid: Record<string, unknown>;
            /** @description The designs one by one. */
            designs?: components["schemas"]["DesignDocument"][];
        };
        /** @description A tire beside the study's own. */
        FurtherTireDocument: {
            /** @description Like no other's, and not `own`. */
            name: string;
            /** @description As a study's scene. */
            scene: Record<string, unknown>;
            /** @description Its own loads, where they differ from the signals', N. */
            loads_n?: number[];
            /** @description Its own pressures, MPa. */
            pressures_mpa?: number[];
            /**
             * Format: double
             * @description Its own load of the pressures, N.
             */
            at_load_n?: number;
            /**
             * Format: double
             * @description Its own load of the contact angles, N.
             */
            contact_load_n?: number;
        };
        /**
         * @description What a note does to the answer; gravest first.
         * @enum {string}
         */
        Grade: "changes-answer" | "bears-on-figure" | "for-the-record";
        /** @description A note with its grade. */
        GradedNote: {
            /** @description What it does to the answer. */
            grade: components["schemas"]["Grade"];
            /** @description What it is about. */
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
            /** @description Its name, of at most 60 characters; its number when left out. */
            name?: string | null;
            /** @description Its films, each at a place of its own. */
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
        /** @description What one location is ranked by. */
        Index: {
            /** @description Name of the location. */
            location: string;
            /** @description Its rank. */
            rank: number;
            /** @description First-order indices for the x and the y strain, percent. */
            gsi_percent: (number | null)[];
            /** @description Their claimed errors, percentage points. */
            error_percent: (number | null)[];
        };
        /** @description Parts of the error of an index, absolute. */
        IndexError: {
            /**
             * Format: double
             * @description From the mesh.
             */
            mesh?: number | null;
            /**
             * Format: double
             * @description From the quadrature rule.
             */
            quadrature?: number | null;
            /**
             * Format: double
             * @description From the decomposition.
             */
            decomposition?: number | null;
            /**
             * Format: double
             * @description Sum of the parts, the largest over the inputs; null where the mesh's part isn't known.
             */
            total?: number | null;
            /** @description Why a part is null. */
            reason?: string | null;
        };
        /** @description First-order indices over the dense grid. */
        IndexMap: {
            /** @description Angles of the columns from the contact centre, degrees. */
            theta_deg: number[];
            /** @description Angles of the rows from the crown, degrees. */
            phi_deg: number[];
            /** @description One layer per direction. */
            layers: components["schemas"]["MapLayer"][];
            shape?: components["schemas"]["MapShape"] | null;
        };
        /** @description One uncertain field of the scene. */
        InputDocument: {
            /** @description Unique. */
            name: string;
            /** @description Path of a number of the scene, as `ground.depths_mm[0]`. */
            vary: string;
            /**
             * @description `kind` is uniform, normal, lognormal, exponential, gamma, weibull, beta, gumbel or triangular, beside it its parameters; any takes
             *     `truncate: [low, high]`.
             */
            distribution: Record<string, unknown>;
        };
        /** @description One input as it was understood. */
        InputReport: {
            /** @description Its name. */
            name: string;
            /** @description Path of the scene's field. */
            vary: string;
            /** @description Its distribution as in the document. */
            distribution: Record<string, unknown>;
        };
        /**
         * @description A kind of model, the simplest first.
         * @enum {string}
         */
        Kind: "mean" | "ridge" | "gpr" | "ann" | "blend";
        /**
         * @description From how many units on more of them bring no more than their number: the worst bound of the angle times the root of the number of units stays within
         *     twice that of a dense ring.
         */
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
             * @description The same of units every 60 degrees, over that of a dense ring; null where they are blind.
             */
            of_60_deg?: number | null;
        };
        /** @description The layout that ranks first. */
        LayoutAnswer: {
            /** @description Its rank in `layouts`. */
            rank: number;
            /** @description What it is, as in `12 units of x and y at the crown, every 30 degrees`. */
            words: string;
            /** @description Its units; of a layout without units its films. */
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
            /** @description How sure the first rank is, by what layouts are ranked by: that error times the root of the number of films. */
            verdict: components["schemas"]["Certainty"];
            /** @description Why, with the figures that decide; where forces along and across are unknown, too, also what tells them from the angle. */
            reason: string;
        };
        /** @description Claimed errors of a layout's scores, each in the unit of its score. */
        LayoutError: {
            /**
             * Format: double
             * @description Of the bound of the angle, worst angle, degrees.
             */
            worst_angle_error_deg?: number | null;
            /**
             * Format: double
             * @description Of the bound of the angle, root mean square, degrees.
             */
            rms_angle_error_deg?: number | null;
            /**
             * Format: double
             * @description Of the bound of the depth, mm.
             */
            worst_depth_error_mm?: number | null;
            /**
             * Format: double
             * @description Of the simulated root mean square, degrees.
             */
            simulated_rms_angle_error_deg?: number | null;
            /**
             * Format: double
             * @description Of the simulated 95th percentile, degrees.
             */
            simulated_p95_angle_error_deg?: number | null;
        };
        /** @description What a study's layouts show together: loads, knees, fronts, second opinions. */
        LayoutFindings: {
            /** @description Mesh level of the fields, which is fine to 60 degrees from the contact. */
            level: string;
            /** @description Unit of films' signals: `strain`, or `V` of glued ones. Noise, weakest signals, candidates' signals and rings are in it. */
            unit?: string;
            /** @description Length and width of the layouts' films, mm; absent of points. */
            size_mm?: number[] | null;
            /** @description Coarser level that shows their errors. */
            coarser_level?: string | null;
            /** @description The loads at which layouts are scored. */
            loads: components["schemas"]["LayoutLoad"][];
            /** @description Layouts that no other beats with as few films, least films first. */
            front: components["schemas"]["FrontLayout"][];
            /**
             * Format: double
             * @description Kendall's tau between the order by simulated errors and that by the bound's worst error times the root of the number of films.
             */
            tau_of_bound?: number | null;
            /** @description What the search looked at. */
            searches?: components["schemas"]["LayoutSearch"][];
            /** @description Kinds of film, ranked by several criteria. */
            candidates: components["schemas"]["CandidateFilm"][];
            /** @description Kendall's tau between each two of these criteria. */
            agreement: components["schemas"]["OrderAgreement"][];
            /** @description Films' signals around the wheel. */
            rings: components["schemas"]["StrainRing"][];
            /** @description Why something is missing, whole sentences. */
            reasons?: string[];
        };
        /** @description A load at which layouts are scored. */
        LayoutLoad: {
            /**
             * Format: double
             * @description How far the ground stands above the inflated outer radius, mm.
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
            /** @description From how many units on each section angle and set of films is dense enough. */
            knees: components["schemas"]["Knee"][];
            /** @description Why there are no scores. */
            reason?: string | null;
        };
        /** @description How well a layout sees the contact, over all angles at which it can touch down. */
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
             * @description Its standard error by the number of simulated contacts, degrees.
             */
            simulated_rms_angle_error_deg_se?: number | null;
            /**
             * Format: double
             * @description 95 % of simulated contacts are estimated better than this, degrees.
             */
            simulated_p95_angle_error_deg?: number | null;
            /**
             * Format: double
             * @description Its standard error by the number of simulated contacts, degrees.
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
             * @description The same as a vertical force, N: by the slope of force over depth.
             */
            force_error_n?: number | null;
            alike?: components["schemas"]["AlikeContacts"] | null;
            dead?: components["schemas"]["DeadFilm"] | null;
            shear?: components["schemas"]["ShearScore"] | null;
            /**
             * Format: double
             * @description Noise of each film assumed for the bounds, in the unit of the signal: strain, or volts of glued films.
             */
            noise_strain: number;
            error?: components["schemas"]["LayoutError"] | null;
            /** @description Why numbers are null. */
            reason?: string | null;
        };
        /** @description What a search looked at. */
        LayoutSearch: {
            /** @description Films of the layouts. */
            films: number;
            /** @description Places that a film may have. */
            places: number;
            /** @description `exhaustive`, or `greedy and exchange`. */
            method: string;
            /** @description What it went by: `bound`, or `interval errors`, which count contacts that are mistaken for others, too. */
            criterion?: string;
            /** @description Layouts whose criterion was computed. */
            looked_at: number;
            /**
             * Format: double
             * @description Bound of the angle with a flat prior of the best one, root mean square over angles and loads, degrees.
             */
            bayes_angle_error_deg: number;
            /** @description Its films. */
            best: components["schemas"]["FilmPlace"][];
        };
        /** @description Ranked layouts. */
        Layouts: {
            /** @description Best first. */
            layouts: components["schemas"]["RankedLayout"][];
            findings?: components["schemas"]["LayoutFindings"] | null;
        };
        /** @description Layouts to score. */
        LayoutsDocument: {
            /** @description Angles between neighbouring units, degrees; each divides 360. */
            spacings_deg?: number[];
            /** @description Numbers of units, beside those of the spacings. */
            units?: number[];
            /** @description crown, shoulder, sidewall */
            positions?: string[];
            /** @description Section angles beside the positions', degrees from the crown. */
            section_deg?: number[];
            /** @description Sets of directions of a unit's films: `"x"`, `"y"`, or an angle in degrees. */
            directions: unknown[][];
            /** @description Whether units of several films are also scored with their films spread between the units. */
            staggered?: boolean;
            /** @description Layouts film by film: `name`, and `films` with `theta_deg`, `phi_deg` and `angle_deg`. */
            free: Record<string, unknown>[];
            /** @description How films are modelled: `bare` when left out, or `transfer`: glued on with their stiffness, by the transfer of two coupled solves, and read in volts. */
            film?: string;
            /** @description Length and width of all films, mm; points when left out, the glued film's with `transfer`. */
            size_mm?: number[];
            /** @description Further lengths and widths that the candidates have, mm. */
            candidate_sizes_mm?: number[][];
            /** @description Depths at which layouts are scored, mm; the mean one when left out. */
            depths_mm?: number[];
            /** @description Forces in their place, N. */
            loads_n?: number[];
            /**
             * Format: double
             * @description Noise of a film over the crown's largest signal; 0.02 when left out.
             */
            noise_share?: number;
            /**
             * Format: double
             * @description Noise of a bare film, strain.
             */
            noise_strain?: number;
            /**
             * Format: double
             * @description Noise of a glued film, V.
             */
            noise_v?: number;
            /**
             * Format: double
             * @description Standard deviation of a film's gain, relative.
             */
            gain_std?: number;
            /**
             * Format: double
             * @description Standard deviation of a film's place around the wheel, degrees.
             */
            place_std_deg?: number;
            /** @description Whether every layout is also scored without the film whose loss costs most. */
            dead?: boolean;
            /** @description Whether forces along the wheel and across it are unknown, too: takes ground with friction, and a solve of the whole tire for every load and mesh. */
            shear?: boolean;
            /** @description Mesh level of the layouts' own solves; the study's, the standard at most, when left out. */
            level?: string;
            /** @description Layouts to search for: numbers of `films` among `slots`, `section_deg` and `directions`. */
            search: Record<string, unknown>;
        };
        /** @description What the model leaves out. */
        LeftOut: {
            /** @description As in `model.left_out`. */
            what: string;
            /** @description As in `model.left_out`. */
            why: string;
            /**
             * Format: double
             * @description Largest change of a strain at P1, P2, ... over the largest strain of its direction.
             */
            effect: number;
            /** @description What it would do, in a sentence. */
            sentence: string;
        };
        /** @description Rows that weren't learnt from. */
        LeftOutForces: {
            /** @description One list a force. */
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
            /** @description What was measured, N. */
            truth_n: number[];
            /** @description What was estimated, N. */
            estimate_n: number[];
            /** @description The interval's low end, N. */
            low_n: number[];
            /** @description The interval's high end, N. */
            high_n: number[];
        };
        /** @description How far one of the solves under way is. */
        LiveSolve: components["schemas"]["SolveProgress"] & {
            /** @description Ordinal of its point in the plan. */
            ordinal: number;
        };
        /** @description A layout's scores at one load. */
        LoadScore: {
            /**
             * Format: double
             * @description How far the ground stands above the inflated outer radius, mm.
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
        /** @description What dragging the ground a little shows at a load. */
        LoadShear: {
            /** @description Forces along the wheel and across it by the shifts that way, N/mm. */
            slopes_n_per_mm: number[];
            /**
             * Format: double
             * @description Force from which the ground slides: the coefficient of friction times the load, N.
             */
            sliding_n: number;
        };
        /** @description Estimated discretisation errors at a location, absolute: see [`crate::gauge::GaugeError`]. */
        LocationError: {
            /**
             * Format: double
             * @description Of the circumferential strain.
             */
            strain_x: number;
            /**
             * Format: double
             * @description Of the meridional strain.
             */
            strain_y: number;
            /**
             * Format: double
             * @description Of the von Mises stress, MPa.
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
            /** @description To be opened once, after the service's own address. */
            path: string;
        };
        /** @description One direction of the map; all lists are rows x columns. */
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
            /**
             * @description Estimated error of the first-order index per input, in the order of the inputs, each rows x columns; empty in documents of earlier
             *     versions.
             */
            first_order_error?: (number | null)[][];
            /** @description Total index per input, in the order of the inputs, each rows x columns: without errors of their own. Empty in documents of earlier versions. */
            total?: (number | null)[][];
            /** @description `ok`, `constant`, `product-form-broken` or `unusable`, rows x columns. */
            status: string[];
        };
        /** @description Where the points of a map lie: x in the rolling direction, y along the axle, z upward, from the wheel's centre. */
        MapShape: {
            /** @description Positions in the inflated state before contact, mm, rows x columns. */
            inflated_mm: number[][];
            /** @description Displacements from there to the equilibrium, mm, rows x columns. */
            displacement_mm: number[][];
        };
        /** @description One layer of the map; lists are rows x columns, all angles of the first row first. */
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
            /** @description Total index of the input, without an error of its own; null unless it is asked for (`index=total`), and of results of earlier versions. */
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
        /** @description How indices are computed. */
        MethodDocument: {
            /** @description mdrm, bivariate, tensor, pce, saltelli or auto. */
            kind?: string;
            /**
             * Format: int32
             * @description Gauss nodes of each input.
             */
            nodes?: number;
            /**
             * Format: int32
             * @description Points off the lines, for the error.
             */
            check_points?: number;
            /**
             * Format: int32
             * @description Points of pce, base points of saltelli.
             */
            samples?: number;
            /**
             * Format: int64
             * @description Of what is random.
             */
            seed?: number;
            /**
             * Format: double
             * @description Largest error of an index at which auto stops.
             */
            tolerance?: number;
            /**
             * Format: int32
             * @description Most runs of auto.
             */
            most_runs?: number;
        };
        /** @description One candidate. */
        ModelReport: {
            /** @description The model. */
            model: components["schemas"]["Kind"];
            /** @description The features it reads. */
            features: components["schemas"]["FeatureSet"];
            /** @description The models whose median a blend is; left out of others. */
            members?: components["schemas"]["MemberReport"][];
            /** @description On the split that chooses. */
            validation: components["schemas"]["SplitReport"];
            /** @description On every split; null where there is none, the reason in the notes. */
            splits: components["schemas"]["SplitReports"];
            /**
             * Format: double
             * @description RMSE on the strictest split over that on the random one: how far a random split would have misled.
             */
            leak_factor?: number | null;
            /** @description Whether its error is at most 95 % of the training mean's on the split that chooses. */
            better_than_mean: boolean;
        };
        /** @description What was modelled and what was left out. */
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
        /** @description How far two criteria order the candidates alike. */
        OrderAgreement: {
            /** @description One criterion. */
            first: string;
            /** @description The other. */
            second: string;
            /**
             * Format: double
             * @description Kendall's tau-b: 1 the same order, -1 the reverse.
             */
            tau?: number | null;
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
            /** @description Why the status is not `ok`. */
            reason?: string | null;
            /** @description What M-DRM said, when its product form is broken. */
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
             * @description Its claimed error; null where it isn't known.
             */
            error?: number | null;
            /** @description How sure the first rank is, by what locations are ranked by. */
            verdict: components["schemas"]["Certainty"];
            /** @description Why, with the figures that decide. */
            reason: string;
            /** @description The place in a sentence. */
            sentence: string;
        };
        /** @description A document to start from. */
        Preset: {
            /** @description What `scene = { preset = ... }` calls it. */
            name: string;
            /** @description Its title. */
            title: string;
            /** @description The document. */
            document: Record<string, unknown>;
            /** @description What it is for. */
            comment: string;
        };
        /** @description The documents that ship. */
        Presets: {
            /** @description Whole studies. */
            studies: components["schemas"]["Preset"][];
            /** @description Scenes alone. */
            scenes: components["schemas"]["Preset"][];
        };
        /** @description A study's places on the draft mesh. It claims nothing: no error is known. */
        Preview: {
            /** @description `none`. */
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
            /** @description What the study would have beside, whole sentences. */
            left_out: string[];
            /** @description What varied. */
            inputs: components["schemas"]["InputReport"][];
            /** @description Ranked locations. */
            locations: components["schemas"]["RankedLocation"][];
            /** @description The response at the means. */
            cut_point: components["schemas"]["CutPoint"];
            map?: components["schemas"]["IndexMap"] | null;
            /** @description What the user must know before believing the numbers, whole sentences. */
            notes: string[];
        };
        /** @description Figures as the published study prints them. */
        PrintedFigures: {
            /**
             * Format: double
             * @description RMSE over the range of the tested forces, %.
             */
            nrmse_percent: number;
            /**
             * Format: double
             * @description Root of the mean squared error, N.
             */
            rmse_n?: number | null;
            /**
             * Format: double
             * @description Coefficient of determination.
             */
            r2?: number | null;
            /**
             * Format: double
             * @description What the mean of the tested forces would have reached, by what the three figures imply, %.
             */
            mean_nrmse_percent?: number | null;
            contradiction?: components["schemas"]["Contradiction"] | null;
        };
        /** @description What a client is told when a request can't be answered: RFC 9457. */
        ProblemDocument: {
            /** @description `about:blank`: the status says what kind of problem it is. */
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
        /** @description One figure of the published study beside the rig's. */
        PublishedRow: {
            /**
             * Format: int32
             * @description Number of the published table.
             */
            table: number;
            /** @description The gait: `randomised`, `1 Hz`, `low frequency` or the like. */
            gait: string;
            /** @description The model. */
            model: components["schemas"]["Kind"];
            /** @description The features it reads. */
            features: components["schemas"]["FeatureSet"];
            /** @description `fx`: along the wheel, `fy`: across it, `fz`: vertical. */
            axis: string;
            /** @description What the rig's model is tested by: `random` readings, later `time`, or another `run`, whose films have other gains. */
            by: components["schemas"]["SplitKind"];
            /** @description As it was printed. */
            printed: components["schemas"]["PrintedFigures"];
            rig?: components["schemas"]["RigFigures"] | null;
            fresh?: components["schemas"]["RigFigures"] | null;
            /** @description Why numbers are null. */
            reason?: string | null;
        };
        /** @description Tables 4, 5, 6, 8 and 9 of the published study and the rig's figures for the same rows, with one layout: six units every 60 degrees at the crown. */
        PublishedTables: {
            /** @description Rank of the layout. */
            layout_rank: number;
            /** @description All rows, in the order of the tables. */
            rows: components["schemas"]["PublishedRow"][];
            /** @description The same layout's forces with other time constants of its circuit. The published study states none. */
            time_constants: components["schemas"]["TimeConstantRow"][];
            /** @description What was done where the published study doesn't say what it did, whole sentences. */
            assumed: string[];
        };
        /** @description One layout in the ranking. */
        RankedLayout: {
            /** @description 1 is best. Layouts of equal score share the rank of the first of them. */
            rank: number;
            /** @description Whether the errors leave no doubt about its place; absent from results of earlier versions. */
            rank_certain?: boolean | null;
            /** @description Name of a layout that was listed film by film, or found by the search; absent of a regular one. */
            name?: string | null;
            /**
             * Format: double
             * @description Angle between neighbouring units, degrees; null of a layout without units.
             */
            spacing_deg?: number | null;
            /** @description Number of units; of a layout without units its number of films. */
            units: number;
            /** @description Meridional position: a name, an angle such as `30 deg`, or `mixed`. */
            position: string;
            /** @description Directions of the films of each unit: `x`, `y`, or an angle such as `45`. */
            films: string[];
            /** @description Whether the films of a unit are spread evenly between two units. */
            staggered?: boolean;
            /** @description All films of the wheel. */
            film_count?: number | null;
            /** @description The films of a layout without units, one by one. */
            places?: components["schemas"]["FilmPlace"][];
            /** @description Which figures may be off by more than a fifth. */
            doubt?: string | null;
            /** @description Its scores at the load where its error is largest. */
            score: components["schemas"]["LayoutScore"];
            /** @description Its scores at every load; absent from results of earlier versions. */
            loads?: components["schemas"]["LoadScore"][];
            /** @description How well it tells the forces along, across and vertical on a virtual rig; absent where the study has none, and of layouts that a search found. */
            force_error?: components["schemas"]["ForceError"][] | null;
        };
        /** @description One candidate location in the ranking. */
        RankedLocation: {
            /** @description P1, P2, ... */
            name: string;
            /** @description The input that is this location's own: the depth of the station below it. */
            input?: string | null;
            /** @description 1 is best. Equal locations, as mirror images are, share the rank of the first of them, and follow each other in the order of their names. */
            rank: number;
            /**
             * Format: double
             * @description 100 times the first-order index of this location's own depth for the x strain at the centre.
             */
            gsi_x_percent?: number | null;
            /**
             * Format: double
             * @description 100 times the first-order index of this location's own depth for the y strain at the centre.
             */
            gsi_y_percent?: number | null;
            /**
             * Format: double
             * @description Error of `gsi_x_percent`, percentage points.
             */
            gsi_x_error_percent?: number | null;
            /**
             * Format: double
             * @description Error of `gsi_y_percent`, percentage points.
             */
            gsi_y_error_percent?: number | null;
            /**
             * Format: double
             * @description Mean over the x strains at all locations.
             */
            mean_gsi_x_percent?: number | null;
            /**
             * Format: double
             * @description Mean over the y strains at all locations.
             */
            mean_gsi_y_percent?: number | null;
            /**
             * Format: double
             * @description For the x strain at this location itself.
             */
            own_gsi_x_percent?: number | null;
            /**
             * Format: double
             * @description For the y strain at this location itself.
             */
            own_gsi_y_percent?: number | null;
            /**
             * Format: double
             * @description What M-DRM said for `gsi_x_percent`, valid or not: the paper's Table 2 as the paper computed it.
             */
            mdrm_gsi_x_percent?: number | null;
            /**
             * Format: double
             * @description What M-DRM said for `gsi_y_percent`, valid or not: the paper's Table 2 as the paper computed it.
             */
            mdrm_gsi_y_percent?: number | null;
            /** @description Rank by the x strain alone, which equal locations share. */
            rank_x?: number | null;
            /** @description Rank by the y strain alone, which equal locations share. */
            rank_y?: number | null;
            /** @description Whether the errors leave no doubt about this rank, which equal locations share. */
            rank_certain: boolean;
        };
        /** @description How far a failed solve got. */
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
        /** @description A recording as text. */
        RecordingDocument: {
            /** @description What faults, reports and plots call it. */
            file: string;
            /** @description CSV: a header, then a row a line: seconds, signals, and forces where they were measured. */
            text: string;
        };
        /** @description One recording. */
        RecordingFigures: {
            /** @description Its file. */
            file: string;
            /** @description Its rows. */
            rows: number;
            /** @description Rows with at least one force. */
            labelled: number;
            /** @description Its cycles. */
            cycles: number;
            /**
             * Format: double
             * @description Rows a second, pauses apart.
             */
            rate_hz?: number | null;
            /** @description Hash of its text. */
            sha256: string;
        };
        /** @description The report of a fit. */
        Report: {
            /** @description What was learnt from. */
            recordings: components["schemas"]["RecordingFigures"][];
            /** @description What was found of each force. */
            forces: components["schemas"]["ForceReport"][];
            /** @description What the intervals promise, a sentence. */
            promise: string;
            /** @description What a reader should know before believing it, a sentence each. */
            notes: string[];
            /** @description What it took. */
            cost: components["schemas"]["FitCost"];
        };
        /** @description How a virtual rig steps, and what its films are wired to. */
        RigDocument: {
            /** @description `frequency` (`kind`: fixed, randomised or transition), `stances` or `run_s`, `contact_deg` and `load_n` (each least and greatest), `duty`, `shear_share`. */
            gait: Record<string, unknown>;
            /** @description `kind` and the fields of a film's amplifier; `time_constant_s`, `bits`, `range_v`. */
            electronics: Record<string, unknown>;
            /** @description `white_share`, `thermal_k`, `drift_share`, `drift_time_s`, `warming_k_per_min`, `gain_std`. */
            noise: Record<string, unknown>;
            /** @description `rate_hz`, `offset_s`, `ppm`, `noise_n`. */
            force_sensor: Record<string, unknown>;
            /** @description Prony branches of the rubber: `share` and `time_s` of each. */
            relaxation: Record<string, unknown>[];
            /** @description Whether films relax as the force does. */
            films_follow_force?: boolean;
            /**
             * Format: double
             * @description Readings of each film a second, Hz.
             */
            film_rate_hz?: number;
            /**
             * Format: int64
             * @description Runs, each with gains of its own.
             */
            runs?: number;
            /**
             * Format: int64
             * @description Of all that is drawn.
             */
            seed?: number;
            /** @description Whether the published study's tables are made, too; it needs its layout among the study's. */
            paper_tables?: boolean;
            /** @description Tires that estimators are tried on, too: `level`, `wall_factor`, `pressure_factor`, `friction_factor`, and whether they are `learnt` from. */
            other_tires: Record<string, unknown>[];
        };
        /** @description Figures of a virtual rig. */
        RigFigures: {
            /**
             * Format: double
             * @description Root of the mean squared error, N.
             */
            rmse_n: number;
            /**
             * Format: double
             * @description RMSE over the range of the tested forces, %.
             */
            nrmse_percent?: number | null;
            /**
             * Format: double
             * @description What the mean of the learnt forces would have reached, %.
             */
            mean_nrmse_percent?: number | null;
            /**
             * Format: double
             * @description Coefficient of determination.
             */
            r2?: number | null;
        };
        /** @description A load of layouts. */
        RingLoad: {
            /**
             * Format: double
             * @description How far the ground stands above the inflated outer radius, mm.
             */
            depth_mm: number;
            /**
             * Format: double
             * @description Vertical force, N; null where it isn't known.
             */
            load_n?: number | null;
        };
        /** @description What is known around the whole wheel. */
        Rings: {
            /** @description What the lists named `strain` and, by the depth, `slope` are in: `strain`, or `V` where layouts are of glued films. */
            unit: string;
            /** @description A ring for each section angle that layouts have; none where the study asks for no layouts. */
            rings: components["schemas"]["WheelRing"][];
        };
        /** @description One way to answer the study, and what it gave. */
        Rung: {
            /** @description In a few words. */
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
        /** @description Layouts with their scores. */
        ScoredLayouts: {
            /** @description In the order of the request. */
            layouts: components["schemas"]["RankedLayout"][];
        };
        /** @description One solved node. */
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
            /**
             * @description From `inflated_mm` to the node's equilibrium, mm, rows x columns: also where the input changes the inflated state. Null where the study was solved by a version
             *     that didn't keep it.
             */
            displacement_mm?: number[][] | null;
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
            /** @description Where the map's points lie in the inflated state at the means, mm, rows x columns; null where the study was solved by a version that didn't keep it. */
            inflated_mm?: number[][] | null;
            /** @description The solved nodes, by value. A design of scattered points has the means alone. */
            nodes: components["schemas"]["SectionNode"][];
            /** @description Nodes that have no equilibrium, by value. */
            failed: components["schemas"]["FailedNode"][];
        };
        /** @description Claimed errors of bounds with four unknowns, each in the unit of its bound. */
        ShearError: {
            /**
             * Format: double
             * @description Of the bound of the angle, degrees.
             */
            worst_angle_error_deg?: number | null;
            /** @description Of the bounds of the forces, N. */
            worst_force_error_n?: (number | null)[] | null;
        };
        /**
         * @description Cramer-Rao bounds with four unknowns: contact angle, depth, and the ground's shifts along the wheel and across it, about a contact that isn't dragged. A
         *     shift across that no film feels doesn't enter.
         */
        ShearScore: {
            /**
             * Format: double
             * @description Of the contact angle, worst angle, degrees.
             */
            worst_angle_error_deg?: number | null;
            /** @description Of the ground's forces on the tire along the wheel, across it (null where no film feels it) and up, worst angle, N. */
            worst_force_error_n?: (number | null)[] | null;
            error?: components["schemas"]["ShearError"] | null;
            /** @description What can't be told. */
            reason?: string | null;
        };
        /**
         * @description What changes along a curve.
         * @enum {string}
         */
        SignalAxis: "load" | "pressure" | "contact";
        /** @description The open circuit's voltage of one film over loads, pressures or contact angles. */
        SignalCurve: {
            /** @description Name of the tire. */
            tire: string;
            /** @description How the film is modelled. */
            film: components["schemas"]["FilmModel"];
            /** @description Where it lies in the section. */
            position: string;
            /** @description Direction of its length. */
            direction: string;
            /** @description What changes along it. */
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
             * @description Of the strain.
             */
            strain: number;
            /**
             * Format: double
             * @description Of the charge, nC.
             */
            charge_nc: number;
            /**
             * Format: double
             * @description Of the open circuit's voltage, V.
             */
            open_circuit_v: number;
            /**
             * Format: double
             * @description Of the amplifier's, V.
             */
            output_v: number;
        };
        /** @description What one film reads of one pressing. */
        SignalRow: {
            /** @description Name of the tire; the study's own is `own`. */
            tire: string;
            /** @description How the film is modelled. */
            film: components["schemas"]["FilmModel"];
            /** @description Where it lies in the section. */
            position: string;
            /** @description Direction of its length: x circumferential, y meridional. */
            direction: string;
            /** @description Which curve it is a point of. */
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
             * @description How far the ground stands above the inflated outer radius, mm.
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
            /** @description Whether the film bears that: `ok`, `beyond-yield` or `wrinkled`; null where that isn't known. */
            state?: string | null;
            error?: components["schemas"]["SignalError"] | null;
            /** @description Why numbers are null. */
            reason?: string | null;
        };
        /** @description Films' signals over load, pressure and contact angle. */
        Signals: {
            /** @description What each film reads of each pressing. */
            rows: components["schemas"]["SignalRow"][];
            /** @description The rows as curves of the open circuit's voltage. */
            curves: components["schemas"]["SignalCurve"][];
            /** @description Two films around the wheel, read against each other. */
            pairs: components["schemas"]["FilmPair"][];
            /** @description How wide the contact is felt around the wheel. */
            widths: components["schemas"]["StressWidth"][];
            /** @description What holds of what is claimed of such films. */
            claims: components["schemas"]["ClaimRow"][];
        };
        /** @description Over which loads, pressures and contact angles films are read, and which films. */
        SignalsDocument: {
            /** @description Loads at the tire's own pressure, N. */
            loads_n?: number[];
            /** @description Internal pressures, MPa. */
            pressures_mpa?: number[];
            /**
             * Format: double
             * @description Load of the pressures, N.
             */
            at_load_n?: number;
            /**
             * Format: double
             * @description Load of the contact angles, N.
             */
            contact_load_n?: number;
            /** @description Wheel angles from a film to the contact, degrees. */
            contact_deg?: number[];
            /** @description crown, shoulder, sidewall */
            positions?: string[];
            /** @description `["x"]`, `["y"]` or both. */
            directions?: string[];
            /** @description bare, transfer, coupled */
            films?: string[];
            /** @description A scene's `film` without its place: `theta_deg`, `phi_deg` and `angle_deg`. */
            film: Record<string, unknown>;
            /** @description Tires beside the study's own. */
            tires?: components["schemas"]["FurtherTireDocument"][];
        };
        /** @description Equilibria that are expected to be solved. */
        SolveForecast: {
            /** @description Points on the meshes of the answer and of the rungs before it. */
            own: number;
            /** @description The same points on coarser meshes, for the error of the mesh. */
            coarser: number;
            /** @description Solves that show what the model leaves out. */
            effects: number;
            /** @description Solves of films' signals, on both meshes. */
            signals?: number;
            /** @description Solves of layouts' loads, on both meshes. */
            layouts?: number;
            /** @description Solves of a rig's table of responses. */
            tables?: number;
            /** @description How many of these the database has already: they cost nothing. */
            known: number;
            /** @description How many are left to solve. */
            left: components["schemas"]["CountForecast"];
        };
        /** @description How far a solve is. */
        SolveProgress: {
            /** @description What is done to the tire. */
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
            rmse_interval_n?: [
                number,
                number
            ] | null;
            /**
             * Format: double
             * @description RMSE over the range of the tested forces, %.
             */
            nrmse_percent?: number | null;
            /**
             * Format: double
             * @description That of the training mean.
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
            /** @description Why numbers are null. */
            reason?: string | null;
        };
        /**
         * @description How rows are divided into those that are learnt from and those that are tested.
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
            /** @description 95 % of the bootstrap's samples of whole cycles, N. */
            rmse_interval_n?: [
                number,
                number
            ] | null;
            /**
             * Format: double
             * @description RMSE over the range of the tested forces, %.
             */
            nrmse_percent?: number | null;
            /**
             * Format: double
             * @description That of the training mean.
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
         * @description What is done to the tire.
         * @enum {string}
         */
        Stage: "inflating" | "pressing";
        /**
         * @description Where a study stands.
         * @enum {string}
         */
        State: "queued" | "running" | "done" | "failed" | "cancelled";
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
            /** @description From -180 to 179 degrees from the contact. */
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
        /** @description One of the events that a stream consists of. */
        StreamEvent: {
            /** @description Its number, for `Last-Event-ID`; `solving` has none. */
            id: string;
            /** @description What happened. */
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
             * @description How far the ground stands above the inflated outer radius, mm.
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
            /** @description Why numbers are null. */
            reason?: string | null;
        };
        /** @description What a study took. */
        StudyCost: {
            /** @description Points of the plan. */
            solves: number;
            /** @description Points of the plan solved once more on a coarser mesh, for the error of the mesh. */
            coarser_solves?: number;
            /** @description Solves that show what the model leaves out. */
            effect_solves?: number;
            /** @description Solves of films' signals, on both meshes. */
            signal_solves?: number;
            /** @description Solves of layouts' loads, on both meshes. */
            layout_solves?: number;
            /** @description Solves of a rig's table of responses. */
            table_solves?: number;
            /** @description Wall-clock time of each rung of the climb, s. */
            rungs_wall_s?: number[];
            /** @description Points taken from the archive instead of being solved. */
            reused: number;
            /** @description Newton iterations of all solves. */
            newton_iterations: number;
            /** @description Factorisations of all solves, without the tangent that the solves from one equilibrium share. */
            factorisations?: number;
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
            substitution_share?: number;
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
        /** @description What varies, and what is asked. Ranges and defaults of single fields are in the faults of a refused document, which names every one of them. */
        StudyDocument: {
            /** @description Free text, not empty. */
            name: string;
            /** @description The scene's tables inline, or a preset's name with whatever differs from it: `{"preset": "foot-tire", ...}`. */
            scene: Record<string, unknown>;
            /** @description What varies. */
            inputs: components["schemas"]["InputDocument"][];
            /** @description Where films may go. */
            candidates?: components["schemas"]["CandidatesDocument"];
            /** @description Layouts to score. */
            layouts?: components["schemas"]["LayoutsDocument"];
            /** @description How indices are computed. */
            method?: components["schemas"]["MethodDocument"];
            /** @description Exactly one of `preset`, `tolerance` and `budget_s`. */
            accuracy?: components["schemas"]["AccuracyDocument"];
            /** @description Films' signals over loads, pressures and contact angles; none where it is left out. */
            signals?: components["schemas"]["SignalsDocument"];
            /** @description A virtual rig that steps on the tire; none where it is left out. */
            rig?: components["schemas"]["RigDocument"];
        };
        /** @description Which study, which document, which program. */
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
        /** @description One page of studies, newest first. */
        StudyPage: {
            /** @description The studies. */
            studies: components["schemas"]["StudySummary"][];
            /** @description Where the next page begins; null on the last one. */
            next_cursor?: string | null;
        };
        /** @description The whole answer. */
        StudyResult: {
            /** @description Which study. */
            study: components["schemas"]["StudyIdentity"];
            answer?: components["schemas"]["Answer"] | null;
            /** @description What was modelled. */
            model: components["schemas"]["ModelSummary"];
            /** @description What varied. */
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
            /** @description What the user must know before believing the numbers, whole sentences: the texts of `graded_notes`. */
            notes: string[];
            /** @description The same with what each does to the answer; empty in results of earlier versions. */
            graded_notes?: components["schemas"]["GradedNote"][];
            /** @description Points that have no equilibrium, with their causes; the indices are taken from the others. */
            failed_points: components["schemas"]["FailedPoint"][];
            /** @description The cut point's own response in short: reaction and strains at the means. */
            cut_point: components["schemas"]["CutPoint"];
            climb?: components["schemas"]["Climb"] | null;
            /** @description What it took. Not part of the result's hash. */
            cost: components["schemas"]["StudyCost"];
            estimate?: components["schemas"]["Estimate"] | null;
        };
        /** @description A study in the queue, at work, or at its end. Times are RFC 3339, UTC. */
        StudySummary: {
            /** @description UUID, ordered by time. */
            id: string;
            /** @description Name in lists: the document's, unless it was changed since. */
            name: string;
            /** @description Where it stands. */
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
            /** @description Why it failed, a sentence. */
            error?: string | null;
            /**
             * Format: int64
             * @description Those of higher priority go first, those of the same in turns.
             */
            priority: number;
            /** @description When it was submitted. */
            created: string;
            /** @description When it was first started. */
            started?: string | null;
            /** @description When it ended. */
            finished?: string | null;
            /** @description When it was archived; null unless it is. */
            archived?: string | null;
        };
        /** @description What a surer answer costs. */
        Surer: {
            /** @description What the next level would do, and how long it would take, in a sentence. */
            sentence: string;
            /** @description Mesh level to ask for. */
            level: string;
            /**
             * Format: double
             * @description Its work over that of this study with nothing solved before, by the law of solve times; null of solvers without one.
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
            /** @description The designs in order. */
            designs: components["schemas"]["DesignView"][];
        };
        /** @description A study, and what its designs set otherwise: `grid` or `designs`. */
        SweepDocument: {
            /** @description Free text; the study's name when left out. */
            name?: string;
            /** @description The study without changes. */
            study: components["schemas"]["StudyDocument"];
            /** @description Lists of values by path, as `{"geometry.wall_mm": [2.5, 3]}`: every combination is a design, the last path varying fastest. */
            grid: Record<string, unknown>;
            /** @description The designs one by one. */
            designs?: components["schemas"]["DesignDocument"][];
        };
        /** @description What a sweep would cost. */
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
        };
        /** @description One page of sweeps, newest first. */
        SweepPage: {
            /** @description The sweeps. */
            sweeps: components["schemas"]["SweepSummary"][];
            /** @description Where the next page begins; null on the last one. */
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
            /** @description When it was submitted. */
            created: string;
            /** @description When its last design ended. */
            finished?: string | null;
            /** @description When it was archived; null unless it is. */
            archived?: string | null;
        };
        /**
         * @description What is wanted of a study.
         * @enum {string}
         */
        Table: "indices" | "locations" | "layouts" | "points" | "signals" | "candidates" | "forces" | "published";
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
        /** @description A layout's force on runs with other gains, with another time constant. */
        TimeConstantRow: {
            /**
             * Format: double
             * @description s
             */
            time_constant_s: number;
            /** @description `fx`, `fy` or `fz`. */
            axis: string;
            /** @description The model that was chosen. */
            chosen: components["schemas"]["Kind"];
            /** @description Its error. */
            error: components["schemas"]["TrialError"];
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
            /** @description What the rungs are compared with. */
            reference: components["schemas"]["Rung"];
            /** @description The rungs, in the order of the ladder. */
            rungs: components["schemas"]["Rung"][];
        };
        /**
         * @description Which way a curve goes.
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
         * @description What a difference is worth.
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
    };
    responses: never;
    parameters: never;
    requestBodies: never;
    headers: never;
    pathItems: never;
}
export type AccuracyDocument = components['schemas']['AccuracyDocument'];
export type AlikeContacts = components['schemas']['AlikeContacts'];
export type Answer = components['schemas']['Answer'];
export type AskewError = components['schemas']['AskewError'];
export type CandidateFilm = components['schemas']['CandidateFilm'];
export type Candidates = components['schemas']['Candidates'];
export type CandidatesDocument = components['schemas']['CandidatesDocument'];
export type Certainty = components['schemas']['Certainty'];
export type Choice = components['schemas']['Choice'];
export type Claim = components['schemas']['Claim'];
export type ClaimRow = components['schemas']['ClaimRow'];
export type Climb = components['schemas']['Climb'];
export type ClimbRung = components['schemas']['ClimbRung'];
export type CoarserIndices = components['schemas']['CoarserIndices'];
export type ComparedIndex = components['schemas']['ComparedIndex'];
export type ComparedLocation = components['schemas']['ComparedLocation'];
export type ComparedStudy = components['schemas']['ComparedStudy'];
export type Comparison = components['schemas']['Comparison'];
export type ComparisonFormat = components['schemas']['ComparisonFormat'];
export type ComparisonTable = components['schemas']['ComparisonTable'];
export type Contradiction = components['schemas']['Contradiction'];
export type CountForecast = components['schemas']['CountForecast'];
export type CutPoint = components['schemas']['CutPoint'];
export type DeadFilm = components['schemas']['DeadFilm'];
export type DeadFilmError = components['schemas']['DeadFilmError'];
export type DesignCounts = components['schemas']['DesignCounts'];
export type DesignDocument = components['schemas']['DesignDocument'];
export type DesignEstimate = components['schemas']['DesignEstimate'];
export type DesignView = components['schemas']['DesignView'];
export type ElsewhereError = components['schemas']['ElsewhereError'];
export type EntryChange = components['schemas']['EntryChange'];
export type Estimate = components['schemas']['Estimate'];
export type EstimatorDetail = components['schemas']['EstimatorDetail'];
export type EstimatorDocument = components['schemas']['EstimatorDocument'];
export type EstimatorPage = components['schemas']['EstimatorPage'];
export type EstimatorSummary = components['schemas']['EstimatorSummary'];
export type EvaluationView = components['schemas']['EvaluationView'];
export type Evaluations = components['schemas']['Evaluations'];
export type ExpectedAccuracy = components['schemas']['ExpectedAccuracy'];
export type FailedNode = components['schemas']['FailedNode'];
export type FailedPoint = components['schemas']['FailedPoint'];
export type Fault = components['schemas']['Fault'];
export type FeatureSet = components['schemas']['FeatureSet'];
export type FidelityReport = components['schemas']['FidelityReport'];
export type FieldLoad = components['schemas']['FieldLoad'];
export type FileFormat = components['schemas']['FileFormat'];
export type FilmAnglesReport = components['schemas']['FilmAnglesReport'];
export type FilmFields = components['schemas']['FilmFields'];
export type FilmKindPlace = components['schemas']['FilmKindPlace'];
export type FilmModel = components['schemas']['FilmModel'];
export type FilmNoise = components['schemas']['FilmNoise'];
export type FilmPair = components['schemas']['FilmPair'];
export type FilmPlace = components['schemas']['FilmPlace'];
export type FitCost = components['schemas']['FitCost'];
export type FitProgress = components['schemas']['FitProgress'];
export type ForceError = components['schemas']['ForceError'];
export type ForceFindings = components['schemas']['ForceFindings'];
export type ForcePrice = components['schemas']['ForcePrice'];
export type ForceReport = components['schemas']['ForceReport'];
export type Forecast = components['schemas']['Forecast'];
export type FormMisses = components['schemas']['FormMisses'];
export type FrontLayout = components['schemas']['FrontLayout'];
export type FurtherDesigns = components['schemas']['FurtherDesigns'];
export type FurtherTireDocument = components['schemas']['FurtherTireDocument'];
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
export type InputDocument = components['schemas']['InputDocument'];
export type InputReport = components['schemas']['InputReport'];
export type Kind = components['schemas']['Kind'];
export type Knee = components['schemas']['Knee'];
export type LayoutAnswer = components['schemas']['LayoutAnswer'];
export type LayoutError = components['schemas']['LayoutError'];
export type LayoutFindings = components['schemas']['LayoutFindings'];
export type LayoutLoad = components['schemas']['LayoutLoad'];
export type LayoutScore = components['schemas']['LayoutScore'];
export type LayoutSearch = components['schemas']['LayoutSearch'];
export type Layouts = components['schemas']['Layouts'];
export type LayoutsDocument = components['schemas']['LayoutsDocument'];
export type LeftOut = components['schemas']['LeftOut'];
export type LeftOutForces = components['schemas']['LeftOutForces'];
export type LeftOutRows = components['schemas']['LeftOutRows'];
export type LiveSolve = components['schemas']['LiveSolve'];
export type LoadScore = components['schemas']['LoadScore'];
export type LoadShear = components['schemas']['LoadShear'];
export type LocationError = components['schemas']['LocationError'];
export type LocationStrain = components['schemas']['LocationStrain'];
export type Locations = components['schemas']['Locations'];
export type LoginLink = components['schemas']['LoginLink'];
export type MapLayer = components['schemas']['MapLayer'];
export type MapShape = components['schemas']['MapShape'];
export type MapView = components['schemas']['MapView'];
export type MemberReport = components['schemas']['MemberReport'];
export type MethodDocument = components['schemas']['MethodDocument'];
export type ModelReport = components['schemas']['ModelReport'];
export type ModelSummary = components['schemas']['ModelSummary'];
export type OrderAgreement = components['schemas']['OrderAgreement'];
export type Output = components['schemas']['Output'];
export type PlaceAnswer = components['schemas']['PlaceAnswer'];
export type Preset = components['schemas']['Preset'];
export type Presets = components['schemas']['Presets'];
export type Preview = components['schemas']['Preview'];
export type PrintedFigures = components['schemas']['PrintedFigures'];
export type ProblemDocument = components['schemas']['ProblemDocument'];
export type PublishedRow = components['schemas']['PublishedRow'];
export type PublishedTables = components['schemas']['PublishedTables'];
export type RankedLayout = components['schemas']['RankedLayout'];
export type RankedLocation = components['schemas']['RankedLocation'];
export type Reached = components['schemas']['Reached'];
export type Readiness = components['schemas']['Readiness'];
export type RecordingDocument = components['schemas']['RecordingDocument'];
export type RecordingFigures = components['schemas']['RecordingFigures'];
export type Report = components['schemas']['Report'];
export type RigDocument = components['schemas']['RigDocument'];
export type RigFigures = components['schemas']['RigFigures'];
export type RingLoad = components['schemas']['RingLoad'];
export type Rings = components['schemas']['Rings'];
export type Rung = components['schemas']['Rung'];
export type ScoredLayouts = components['schemas']['ScoredLayouts'];
export type SectionNode = components['schemas']['SectionNode'];
export type Sections = components['schemas']['Sections'];
export type ShearError = components['schemas']['ShearError'];
export type ShearScore = components['schemas']['ShearScore'];
export type SignalAxis = components['schemas']['SignalAxis'];
export type SignalCurve = components['schemas']['SignalCurve'];
export type SignalError = components['schemas']['SignalError'];
export type SignalRow = components['schemas']['SignalRow'];
export type Signals = components['schemas']['Signals'];
export type SignalsDocument = components['schemas']['SignalsDocument'];
export type SolveForecast = components['schemas']['SolveForecast'];
export type SolveProgress = components['schemas']['SolveProgress'];
export type SplitError = components['schemas']['SplitError'];
export type SplitKind = components['schemas']['SplitKind'];
export type SplitReport = components['schemas']['SplitReport'];
export type SplitReports = components['schemas']['SplitReports'];
export type Stage = components['schemas']['Stage'];
export type State = components['schemas']['State'];
export type StrainRing = components['schemas']['StrainRing'];
export type StreamEvent = components['schemas']['StreamEvent'];
export type StressWidth = components['schemas']['StressWidth'];
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
export type TimeConstantRow = components['schemas']['TimeConstantRow'];
export type Topic = components['schemas']['Topic'];
export type Trade = components['schemas']['Trade'];
export type Trend = components['schemas']['Trend'];
export type TrialError = components['schemas']['TrialError'];
export type Verdict = components['schemas']['Verdict'];
export type WheelRing = components['schemas']['WheelRing'];
export type WorstContact = components['schemas']['WorstContact'];
export type $defs = Record<string, never>;
export type operations = Record<string, never>;
