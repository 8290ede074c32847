package rigibo.backend.impact;

import rigibo.backend.algebra.EnvelopeFactor;
import rigibo.backend.storage.RoundOff;

/**
 * Solves all active rows of tied impacts as one system of equations: points that push, friction
 * inside its cone, and friction on its cone, which is proportional to the normal impulse. Passes
 * identify the active rows well but approach their impulses slowly; this is Newton's method on
 * Coulomb's law (P. Alart and A. Curnier, 1991), started from the result of the passes.
 */
final class TiedElimination {

    /** Number of rows above which elimination takes longer than passes. */
    private static final int MOST_ROWS = 96;

    /** Compliance of a row as a share of its response, so that redundant rows share their load. */
    private static final double GIVE = 1e-10;

    /**
     * Largest change of its own speed that a row's impulse may cause, as a multiple of the fastest
     * approach. A larger one means that the equations contradict each other and only the compliance
     * bounds the solution.
     */
    private static final double FARTHEST = 1e4;

    private final TiedRows rows;

    /** The active rows: those that are equations. */
    private int[] set = new int[16];

    /** By row: its place among the active rows. */
    private int[] place = new int[16];

    private int size;

    private final EnvelopeFactor factor = new EnvelopeFactor();

    /** By active row: change of impulse that solves the equations, N·s. */
    private double[] lacks = new double[16];

    TiedElimination(TiedRows rows) {
        this.rows = rows;
    }

    /**
     * Moves the impulses to the solution of the active rows, or towards it up to the first bound.
     *
     * @param fastest fastest approach of any row before the impacts, m/s
     * @return multiplications done, 0 if there was nothing to solve
     */
    double solve(double fastest) {
        // Whether bodies side by side press each other by 10⁻¹⁷ N·s must not choose the equations.
        choose(RoundOff.OF_SUMS * fastest);
        if (size < 2 || size > MOST_ROWS) {
            return 0;
        }
        factor.clearWork();
        factorize();
        for (int i = 0; i < size; i++) {
            lacks[i] = rows.target[set[i]] - rows.speed(set[i]);
        }
        factor.solve(lacks);
        if (isFartherThan(FARTHEST * fastest)) {
            return 0;
        }
        double share = shareToFirstBound();
        for (int i = 0; i < size; i++) {
            rows.push(set[i], share * lacks[i]);
        }
        for (int row = 0; row < rows.count; row++) {
            if (isSliding(row)) {
                double rubs = Math.copySign(rows.cone(row), rows.impulse[row]);
                rows.push(row, rubs - rows.impulse[row]);
            }
        }
        return factor.work();
    }

    /** Chooses the rows that carry, or may rub by, what gives them more than a speed in m/s. */
    private void choose(double least) {
        if (set.length < rows.count) {
            set = new int[rows.pair.length];
            place = new int[rows.pair.length];
            lacks = new double[rows.pair.length];
            factor.reserve(rows.pair.length);
        }
        size = 0;
        for (int row = 0; row < rows.count; row++) {
            boolean isNormal = rows.points[row] == 0;
            double impulse = rows.impulse[row];
            double most = isNormal ? impulse : rows.cone(row);
            boolean isEquation =
                    most * rows.response[row] > least && (isNormal || Math.abs(impulse) < most);
            place[row] = isEquation ? size : TiedRows.NONE;
            if (isEquation) {
                set[size++] = row;
            }
        }
    }

    /** Whether a tangent's friction is on its cone. */
    private boolean isSliding(int row) {
        return rows.points[row] > 0 && place[row] == TiedRows.NONE && rows.impulse[row] != 0;
    }

    /** The friction that comes with a unit impulse of a tangent's normals. */
    private double slides(int tangent) {
        return Math.copySign(rows.friction[tangent], rows.impulse[tangent]);
    }

    /** Speed that a unit impulse of one row, with the friction it causes, gives another, 1/kg. */
    private double answer(int i, int j) {
        double direct = rows.response(i, j);
        int tangent = rows.tangent[j];
        boolean slides = rows.points[j] == 0 && tangent != TiedRows.NONE && isSliding(tangent);
        return slides ? direct + slides(tangent) * rows.response(i, tangent) : direct;
    }

    /** Factors the equations in the order of the rows, without using sparsity. */
    private void factorize() {
        factor.lay(size);
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < i; j++) {
                factor.writeLower(i, j, answer(set[i], set[j]));
                factor.writeUpper(i, j, answer(set[j], set[i]));
            }
            double gives = GIVE * rows.response[set[i]];
            factor.writeLower(i, i, answer(set[i], set[i]) + gives);
            factor.eliminate(i, false, gives);
        }
    }

    private boolean isFartherThan(double speed) {
        for (int i = 0; i < size; i++) {
            if (!(Math.abs(lacks[i]) * rows.response[set[i]] <= speed)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Share of the way to the solution up to which no point pulls and no friction leaves its cone.
     */
    private double shareToFirstBound() {
        double share = 1;
        for (int i = 0; i < size; i++) {
            int row = set[i];
            if (rows.points[row] == 0) {
                if (rows.impulse[row] + lacks[i] < 0) {
                    share = Math.min(share, -rows.impulse[row] / lacks[i]);
                }
            } else {
                share = Math.min(share, shareToCone(row, lacks[i]));
            }
        }
        return share;
    }

    private double shareToCone(int tangent, double lack) {
        double grows = 0;
        for (int row = tangent - rows.points[tangent]; row < tangent; row++) {
            grows += place[row] == TiedRows.NONE ? 0 : lacks[place[row]];
        }
        grows *= rows.friction[tangent];
        double cone = rows.cone(tangent);
        double side = Math.signum(rows.impulse[tangent] + lack);
        double room = cone - side * rows.impulse[tangent];
        double taken = side * lack - grows;
        return taken > room ? Math.max(0, room) / taken : 1;
    }
}
