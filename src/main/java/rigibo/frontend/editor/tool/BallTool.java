package rigibo.frontend.editor.tool;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.draft.Point;

/** Sets further balls; each must reach the platform. */
public final class BallTool implements Tool {

    private final Desk desk;

    public BallTool(Desk desk) {
        this.desk = desk;
    }

    @Override
    public void pressed(Point at) {}

    @Override
    public void released(Point at) {
        desk.history().begin();
        desk.placeBall(at);
        desk.item().map(desk.grid()::snap).ifPresent(desk::put);
        desk.history().end();
    }
}
