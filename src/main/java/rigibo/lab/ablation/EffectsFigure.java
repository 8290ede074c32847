package rigibo.lab.ablation;

import rigibo.lab.plot.Anchor;
import rigibo.lab.plot.Drawing;
import rigibo.lab.plot.Palette;

/** A picture of the findings in three independent panels. */
final class EffectsFigure {

    static final double WIDTH = 1000;
    private static final double MARGIN = 40;
    private static final double BETWEEN = 60;
    private static final int TITLE_SIZE = 18;

    private final Findings findings;
    private final Drawing picture = new Drawing(WIDTH);

    EffectsFigure(Findings findings) {
        this.findings = findings;
    }

    /** The picture in SVG. */
    String text() {
        double y = title(MARGIN, "Undeclared effects: their classes there or taken out");
        y = new RatioPanel(findings.ablations()).draw(picture, y) + BETWEEN;
        if (!findings.uses().isEmpty()) {
            y = title(y, "Declared effects: cost per step by how many bodies use them");
            y = new UsePanel(findings).draw(picture, y) + BETWEEN;
        }
        y = title(y, "Left out: what a step of each scene saves");
        y = new SavingPanel(findings).draw(picture, y);
        picture.endAt(y + MARGIN);
        return picture.svg();
    }

    private double title(double y, String words) {
        picture.text(MARGIN, y, Anchor.START, TITLE_SIZE, Palette.INK, words);
        return y + 24;
    }
}
