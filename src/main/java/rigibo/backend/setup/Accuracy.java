package rigibo.backend.setup;

/**
 * How accurately a pool simulates, and so how much time it takes. The presets are measured choices;
 * a {@code with…} method changes one knob and leaves the others as they are.
 *
 * <pre>{@code
 * pool.accuracy(Accuracy.EXACT);
 * pool.accuracy(Accuracy.GAME.withSubsteps(8)); // between two steps
 * }</pre>
 *
 * @param substeps substeps per step, 1 to 64, of piles and of flight under forces that vary along
 *     the path; the time of both grows with it
 * @param velocityIterations solver passes over the contacts per substep, 1 to 8
 * @param impacts at what time within a step impacts are resolved; treated as {@code DISCRETE} where
 *     {@code ContinuousImpacts} is not declared
 * @param impactTolerance largest gap at which an impact may be resolved, 1e-9 to 1e-3 m for a body
 *     one metre wide; scales with the width of the body
 * @param search how the time of impact is searched for
 * @param maxImpactsPerPair impacts of one pair in one step, 4 to 64, after which the pair counts as
 *     resting or, at a wall with an elasticity of 1, waits for the next step
 * @param integrator how bodies in flight are integrated
 * @param contactSolver how the impulses of contacts are solved for
 * @param correction how overlap is removed
 */
public record Accuracy(
        int substeps,
        int velocityIterations,
        ImpactMode impacts,
        double impactTolerance,
        ImpactSearch search,
        int maxImpactsPerPair,
        Integrator integrator,
        ContactSolver contactSolver,
        Correction correction) {

    /** Fast and plausible: 1 substep, split impacts. What is struck hard may sink in visibly. */
    public static final Accuracy DRAFT =
            new Accuracy(
                    1,
                    1,
                    ImpactMode.SPLIT,
                    1e-3,
                    ImpactSearch.ITP,
                    4,
                    Integrator.BALLISTIC,
                    ContactSolver.DIRECT,
                    Correction.SOFT);

    /** The game's preset: 4 substeps, impacts in time order within 0.1 mm. */
    public static final Accuracy GAME =
            new Accuracy(
                    4,
                    1,
                    ImpactMode.EVENTS,
                    1e-4,
                    ImpactSearch.ITP,
                    16,
                    Integrator.BALLISTIC,
                    ContactSolver.DIRECT,
                    Correction.SOFT);

    /** For measurements: 8 substeps, impacts within 1 µm. */
    public static final Accuracy FINE =
            GAME.withSubsteps(8).withImpactTolerance(1e-6).withMaxImpactsPerPair(32);

    /** For references, the most accurate preset: 16 substeps, impacts within 1 nm. */
    public static final Accuracy EXACT =
            GAME.withSubsteps(16).withImpactTolerance(1e-9).withMaxImpactsPerPair(64);

    /**
     * Checks every knob.
     *
     * @throws IllegalArgumentException naming the knob that is out of its range
     */
    public Accuracy {
        Require.within("Accuracy.substeps", substeps, 1, 64);
        Require.within("Accuracy.velocityIterations", velocityIterations, 1, 8);
        Require.present("Accuracy.impacts", impacts);
        Require.within("Accuracy.impactTolerance", impactTolerance, 1e-9, 1e-3, "m");
        Require.present("Accuracy.search", search);
        Require.within("Accuracy.maxImpactsPerPair", maxImpactsPerPair, 4, 64);
        Require.present("Accuracy.integrator", integrator);
        Require.present("Accuracy.contactSolver", contactSolver);
        Require.present("Accuracy.correction", correction);
    }

    /** A copy with another number of substeps, 1 to 64. */
    public Accuracy withSubsteps(int count) {
        return new Accuracy(
                count,
                velocityIterations,
                impacts,
                impactTolerance,
                search,
                maxImpactsPerPair,
                integrator,
                contactSolver,
                correction);
    }

    /** A copy with another number of solver passes per substep, 1 to 8. */
    public Accuracy withVelocityIterations(int count) {
        return new Accuracy(
                substeps,
                count,
                impacts,
                impactTolerance,
                search,
                maxImpactsPerPair,
                integrator,
                contactSolver,
                correction);
    }

    /** A copy that resolves impacts at other times. */
    public Accuracy withImpacts(ImpactMode mode) {
        return new Accuracy(
                substeps,
                velocityIterations,
                mode,
                impactTolerance,
                search,
                maxImpactsPerPair,
                integrator,
                contactSolver,
                correction);
    }

    /** A copy with another impact tolerance, 1e-9 to 1e-3 m. */
    public Accuracy withImpactTolerance(double metres) {
        return new Accuracy(
                substeps,
                velocityIterations,
                impacts,
                metres,
                search,
                maxImpactsPerPair,
                integrator,
                contactSolver,
                correction);
    }

    /** A copy with another search for the time of impact. */
    public Accuracy withSearch(ImpactSearch method) {
        return new Accuracy(
                substeps,
                velocityIterations,
                impacts,
                impactTolerance,
                method,
                maxImpactsPerPair,
                integrator,
                contactSolver,
                correction);
    }

    /** A copy with another limit of impacts of one pair in a step, 4 to 64. */
    public Accuracy withMaxImpactsPerPair(int count) {
        return new Accuracy(
                substeps,
                velocityIterations,
                impacts,
                impactTolerance,
                search,
                count,
                integrator,
                contactSolver,
                correction);
    }

    /** A copy with another integrator of flight. */
    public Accuracy withIntegrator(Integrator method) {
        return new Accuracy(
                substeps,
                velocityIterations,
                impacts,
                impactTolerance,
                search,
                maxImpactsPerPair,
                method,
                contactSolver,
                correction);
    }

    /** A copy with another contact solver. */
    public Accuracy withContactSolver(ContactSolver method) {
        return new Accuracy(
                substeps,
                velocityIterations,
                impacts,
                impactTolerance,
                search,
                maxImpactsPerPair,
                integrator,
                method,
                correction);
    }

    /** A copy with another removal of overlap. */
    public Accuracy withCorrection(Correction method) {
        return new Accuracy(
                substeps,
                velocityIterations,
                impacts,
                impactTolerance,
                search,
                maxImpactsPerPair,
                integrator,
                contactSolver,
                method);
    }
}
