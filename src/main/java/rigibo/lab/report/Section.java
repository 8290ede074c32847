package rigibo.lab.report;

import rigibo.lab.plot.Drawing;

import java.util.List;

/**
 * A part of a report: what is to be seen, in words, and where.
 *
 * @param name of its files, without an ending
 * @param title over it
 * @param sentences before the figure
 * @param figures the wide one and the narrow one, which is for a phone; none where there are none
 * @param tables after the figure
 */
public record Section(
        String name,
        String title,
        List<String> sentences,
        List<Drawing> figures,
        List<Table> tables) {}
