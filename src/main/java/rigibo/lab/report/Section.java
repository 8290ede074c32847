package rigibo.lab.report;

import rigibo.lab.plot.Drawing;

import java.util.List;

/**
 * A part of a report: sentences, figures and tables.
 *
 * @param name name of its files, without an ending
 * @param title its heading
 * @param sentences before the figure
 * @param figures the wide figure, and the narrow one for phones; may be empty
 * @param tables after the figure
 */
public record Section(
        String name,
        String title,
        List<String> sentences,
        List<Drawing> figures,
        List<Table> tables) {}
