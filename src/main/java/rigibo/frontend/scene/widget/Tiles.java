package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.PointerButton;

import java.util.List;

/** Tiles, one of which is selected, by the pointer, by arrow keys or by Tab. */
public final class Tiles {

    /** Weight of the distance across an arrow's direction, compared with the distance along it. */
    private static final double ASIDE = 3;

    /** The selection while no tile is selected; Enter then does nothing. */
    public static final int NONE = -1;

    private final List<Tile> tiles;
    private int chosen;

    /** Tiles with one of them, from 0, or {@link #NONE} chosen. */
    public Tiles(List<Tile> tiles, int chosen) {
        this.tiles = List.copyOf(tiles);
        this.chosen = chosen;
    }

    /** Draws them all. */
    public void draw(Canvas canvas) {
        for (int i = 0; i < tiles.size(); i++) {
            tiles.get(i).draw(canvas, i == chosen);
        }
    }

    /** Tells of them all. */
    public void describe(Narrator narrator) {
        for (int i = 0; i < tiles.size(); i++) {
            tiles.get(i).describe(narrator, i == chosen);
        }
    }

    /** Which of them is chosen, from 0, or {@link #NONE}. */
    public int chosen() {
        return chosen;
    }

    /** Chooses one of them, from 0. */
    public void choose(int tile) {
        chosen = tile;
    }

    /** The pointer moved, px: the tile under it is selected. */
    public void pointerMoved(double x, double y) {
        int under = at(x, y);
        chosen = under < 0 ? chosen : under;
    }

    /** A button went down, px: the left one uses the tile under the pointer. */
    public void pointerPressed(PointerButton button, double x, double y) {
        int under = at(x, y);
        if (under >= 0 && button == PointerButton.LEFT) {
            chosen = under;
            tiles.get(under).action().run();
        }
    }

    private int at(double x, double y) {
        for (int i = 0; i < tiles.size(); i++) {
            if (tiles.get(i).contains(x, y)) {
                return i;
            }
        }
        return -1;
    }

    /** Arrows and Tab select a tile; Enter and the space bar use it. */
    public void keyPressed(Key key) {
        switch (key) {
            case UP -> chosen = towards(0, -1);
            case DOWN -> chosen = towards(0, 1);
            case LEFT -> chosen = towards(-1, 0);
            case RIGHT -> chosen = towards(1, 0);
            case TAB -> chosen = (chosen + 1) % tiles.size();
            case ENTER, SPACE -> use();
            default -> {}
        }
    }

    private void use() {
        if (chosen != NONE) {
            tiles.get(chosen).action().run();
        }
    }

    /** The nearest tile in a direction, or the present one where there is none. */
    private int towards(int right, int down) {
        if (chosen == NONE) {
            return 0;
        }
        Tile from = tiles.get(chosen);
        int nearest = chosen;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < tiles.size(); i++) {
            double dx = tiles.get(i).middleX() - from.middleX();
            double dy = tiles.get(i).middleY() - from.middleY();
            double along = dx * right + dy * down;
            double aside = Math.abs(dx * down) + Math.abs(dy * right);
            double distance = along + ASIDE * aside;
            if (along > 1 && distance < least) {
                least = distance;
                nearest = i;
            }
        }
        return nearest;
    }
}
