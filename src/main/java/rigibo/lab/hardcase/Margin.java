package rigibo.lab.hardcase;

/**
 * The worst figure of a case at a preset.
 *
 * @param row the case's number in the catalogue of hard cases
 * @param preset how exactly it was run
 * @param worst the figure that comes nearest to its limit, or is farthest beyond it
 */
public record Margin(String row, Preset preset, Measure worst) {

    static Margin of(HardCase.Result result) {
        return new Margin(result.hardCase().row(), result.preset(), result.worst());
    }

    /** Whether the case keeps all of its limits. */
    boolean passes() {
        return worst.passes();
    }
}
