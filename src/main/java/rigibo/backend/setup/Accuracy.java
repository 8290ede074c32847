package rigibo.backend.setup;

/**
 * How exactly a pool is to be simulated, and so what it costs. Every knob can be turned alone with
 * its {@code with…} method; the presets are choices that were measured.
 *
 * <pre>{@code
 * pool.accuracy(Accuracy.EXACT);
 * pool.accuracy(Accuracy.GAME.withSubsteps(8)); // between two steps
 * }</pre>
 *
 * @param substeps 1 to 64 substeps of a pile per step, and of a flight under forces that change
 *     along the way; their time grows with it
 * @param velocityIterations 1 to 8 passes over the contacts per substep
 * @param impacts when impacts happen; {@code DISCRETE} wherever {@code ContinuousImpacts} is not
 *     declared
 * @param impactTolerance 1e-9 to 1e-3 m, for a body of one metre: how far before touching an impact
 *     may be taken
 * @param search how the time of an impact is found
 * @param maxImpactsPerPair 4 to 64 impacts of one pair in one step before it counts as resting, or
 *     waits for the next step at a wall where its elasticity is 1
 * @param integrator how flight is integrated
 * @param contactSolver how contact impulses are found
 * @param correction what is done about overlap
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

    /** Fast and plausible: 1 substep, split impacts. What is fast and turns may sink in deep. */
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

    /** The game's: 4 substeps, impacts at their times within 0.1 mm. */
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

    /** Measurable: 8 substeps, impacts within a micrometre. */
    public static final Accuracy FINE =
            GAME.withSubsteps(8).withImpactTolerance(1e-6).withMaxImpactsPerPair(32);

    /**
     * The most exact of the four: 16 substeps, impacts within a nanometre, small islands solved
     * directly.
     */
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

    /** The same with another number of substeps, 1 to 64. */
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

    /** The same with another number of passes per substep, 1 to 8. */
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

    /** The same with impacts at other times. */
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

    /** The same with another tolerance of impacts, 1e-9 to 1e-3 m. */
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

    /** The same with another search for the time of impact. */
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

    /** The same with another most number of impacts of a pair in a step, 4 to 64. */
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

    /** The same with another integrator of flight. */
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

    /** The same with another contact solver. */
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

    /** The same with another treatment of overlap. */
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
