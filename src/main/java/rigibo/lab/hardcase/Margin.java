package rigibo.lab.hardcase;

/**
 * How a case came out at a preset, in short.
 *
 * @param row the case's number in the catalogue of hard cases
 * @param preset how exactly it was run
 * @param worst the figure that comes nearest to its limit, or is farthest beyond it
 */
public record Margin(String row, Preset preset, Measure worst) {

    private static final String BETWEEN_FIELDS = "\t";
    private static final int FIELDS = 6;

    static Margin of(HardCase.Result result) {
        return new Margin(result.hardCase().row(), result.preset(), result.worst());
    }

    /** Whether the case keeps all of its limits. */
    boolean passes() {
        return worst.passes();
    }

    /** All but where it was seen, in one line for a log. */
    String line() {
        return String.join(
                BETWEEN_FIELDS,
                row,
                preset.name(),
                worst.name(),
                String.valueOf(worst.figure()),
                String.valueOf(worst.limit()),
                worst.unit());
    }

    /**
     * What a line says.
     *
     * @throws IllegalArgumentException when it is cut short or not such a line
     */
    static Margin parse(String line) {
        String[] field = line.split(BETWEEN_FIELDS, -1);
        if (field.length != FIELDS) {
            throw new IllegalArgumentException("not a margin: '" + line + "'");
        }
        double figure = Double.parseDouble(field[3]);
        double limit = Double.parseDouble(field[4]);
        Measure worst = new Measure(field[2], figure, limit, field[5], "");
        return new Margin(field[0], Preset.valueOf(field[1]), worst);
    }
}
