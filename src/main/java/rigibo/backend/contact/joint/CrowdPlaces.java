package rigibo.backend.contact.joint;

/**
 * Removes the position errors of a crowd's joints by moving bodies: limits first, then equations,
 * which hold in the end. A chain that is free at one end closes without moving any body farther
 * than the sum of all errors. A bridge as long as its span would ask for far more: n hinges that
 * are off by e let its middle leave the line by √(L·n·e/2), and in a single substep it would pass
 * through what lies on it.
 */
final class CrowdPlaces {

    /**
     * Largest displacement of an outline, as a multiple of the sum of the equations' errors. It is
     * above 1 since bodies turn.
     */
    private static final double FEW = 4;

    private final NeutralRows rows;
    private final JointPlaces jointPlaces;
    private final EquationFactor factor;
    private final EquationList equations;
    private final AssemblyTree tree;
    private final BoundedRows bounded;
    private final GroupVelocities velocities;

    /** Error that does not count, as a share of the joint's size. */
    private final double seen;

    /** By row: its own compliance, while equations give way. */
    private double[] give = new double[64];

    /** Sum of the errors of the group that was asked last, m. */
    private double asked;

    CrowdPlaces(
            NeutralRows rows,
            JointPlaces jointPlaces,
            EquationFactor factor,
            BoundedRows bounded,
            GroupVelocities velocities,
            double seen) {
        this.rows = rows;
        this.jointPlaces = jointPlaces;
        this.factor = factor;
        equations = factor.equations();
        tree = factor.tree();
        this.bounded = bounded;
        this.velocities = velocities;
        this.seen = seen;
    }

    /** Moves bodies at the start of a part of h seconds whose rows are written and listed. */
    void correct(double h) {
        double most = GroupVelocities.MOST_MOVED * Math.abs(h);
        velocities.begin();
        velocities.rest();
        jointPlaces.measureAnew();
        boolean isAny = bounded.correct(most, seen);
        for (int group = 0; group < tree.groups; group++) {
            if (ask(group, most) > seen) {
                isAny = true;
                close(group, most);
            }
        }
        if (isAny) {
            velocities.move(h);
        }
    }

    /**
     * Closes a group that was asked, with the smallest compliance of its equations at which no
     * outline goes too far (damped least squares, K. Levenberg 1944).
     */
    private void close(int group, double most) {
        velocities.keep(group);
        displace(group);
        double share = PlaceRecovery.LEAST_GIVE;
        while (velocities.farthest(group) > FEW * asked && share <= PlaceRecovery.MOST_GIVE) {
            velocities.recall(group);
            giveWay(group, share);
            ask(group, most);
            displace(group);
            hold(group);
            share *= PlaceRecovery.MORE_GIVE;
        }
        double farthest = velocities.farthest(group);
        if (farthest > FEW * asked) {
            velocities.scale(group, FEW * asked / farthest);
        }
    }

    private void displace(int group) {
        factor.solve(group);
        for (int i = tree.equationStart[group]; i < tree.equationStart[group + 1]; i++) {
            int e = tree.equationOf[i];
            if (equations.row[e] != EquationList.NONE) {
                velocities.displace(equations.row[e], factor.answer(e));
            }
        }
    }

    private void giveWay(int group, double share) {
        if (give.length < rows.count) {
            give = new double[rows.bodies.length];
        }
        for (int i = tree.equationStart[group]; i < tree.equationStart[group + 1]; i++) {
            int row = equations.row[tree.equationOf[i]];
            if (row != EquationList.NONE) {
                give[row] = rows.give[row];
                rows.give[row] += share * rows.response[row];
            }
        }
        factor.change(group);
    }

    private void hold(int group) {
        for (int i = tree.equationStart[group]; i < tree.equationStart[group + 1]; i++) {
            int row = equations.row[tree.equationOf[i]];
            if (row != EquationList.NONE) {
                rows.give[row] = give[row];
            }
        }
        factor.change(group);
    }

    /**
     * Asks for the removal of a group's errors, each by at most a share of its joint's size;
     * returns the largest such error, as a share likewise.
     */
    private double ask(int group, double most) {
        double farthest = 0;
        asked = 0;
        for (int i = tree.equationStart[group]; i < tree.equationStart[group + 1]; i++) {
            int e = tree.equationOf[i];
            int row = equations.row[e];
            double back = 0;
            if (row != EquationList.NONE) {
                double size = jointPlaces.size(row);
                double within = Math.max(-most * size, Math.min(most * size, off(row)));
                back = -within - velocities.along(row);
                farthest = Math.max(farthest, Math.abs(back) / size);
                asked += rows.inMetres(row, Math.abs(back));
            }
            factor.ask(e, back);
        }
        return farthest;
    }

    /** How far a row that holds is off its place, m or rad. */
    private double off(int row) {
        if (!rows.holdsPlace[row]) {
            return 0;
        }
        return rows.isEquation(row) ? rows.place[row] : Math.min(0, rows.place[row]);
    }
}
