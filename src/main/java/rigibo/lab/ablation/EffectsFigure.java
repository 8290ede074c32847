package rigibo.lab.ablation;

/** The findings as one picture of three panels, each to be read by itself. */
final class EffectsFigure {

    static final double WIDTH = 1000;
    private static final double MARGIN = 40;
    private static final double BETWEEN = 60;
    private static final int TITLE_SIZE = 18;

    private final Findings findings;
    private final Svg svg = new Svg();

    EffectsFigure(Findings findings) {
        this.findings = findings;
    }

    /** The picture in SVG. */
    String text() {
        double y = title(MARGIN, "Undeclared effects: their classes there or taken out");
        y = new RatioPanel(findings.ablations()).draw(svg, y) + BETWEEN;
        if (!findings.uses().isEmpty()) {
            y = title(y, "Declared effects: cost per step by how many bodies use them");
            y = new UsePanel(findings).draw(svg, y) + BETWEEN;
        }
        y = title(y, "Left out: what a step of each scene saves");
        y = new SavingPanel(findings).draw(svg, y);
        return svg.text(WIDTH, y + MARGIN);
    }

    private double title(double y, String words) {
        svg.text(MARGIN, y, Svg.Anchor.START, TITLE_SIZE, Svg.INK, words);
        return y + 24;
    }
}
