package rigibo.frontend.scene;

/** Tells of controls on an enlarged canvas where they are on the canvas below it. */
record EnlargedNarrator(Enlarged canvas, Narrator narrator) implements Narrator {

    @Override
    public void offers(Control control) {
        double left = canvas.outX(control.x());
        double top = canvas.outY(control.y());
        narrator.offers(
                new Control(
                        control.name(),
                        control.kind(),
                        left,
                        top,
                        canvas.outX(control.x() + control.width()) - left,
                        canvas.outY(control.y() + control.height()) - top,
                        control.share(),
                        control.isChosen()));
    }

    @Override
    public void says(String words) {
        narrator.says(words);
    }
}
