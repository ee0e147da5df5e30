using Engraver.Core.Drawings;

namespace Engraver.Workbench.Lettering.Paragraphs;

/// <summary>The columns into which an MTEXT flows. Their tops are at the same height.</summary>
/// <param name="Width">Of one column; 0 for a text that does not wrap.</param>
/// <param name="Count">0 for as many as the text fills.</param>
/// <param name="Heights">Of the first columns; 0 for one that takes the rest.</param>
/// <param name="Height">Of the other columns; 0 where it is not stated.</param>
/// <param name="IsReversed">The first column is at the right.</param>
internal sealed record ColumnPlan(double Width, double Gutter, int Count, IReadOnlyList<double> Heights, double Height, bool IsReversed)
{
    private const int StaticColumns = 1;

    /// <summary>Files before 2018 have the second and following columns in records of their own, so the text of this record is the first column.</summary>
    public static ColumnPlan Of(WrittenParagraphs written) => written.Columns switch
    {
        null => Single(written.ReferenceWidth),
        { LinkedHandles.Count: > 0 } columns => Single(columns.Width > 0.0 ? columns.Width : written.ReferenceWidth),
        var columns => new ColumnPlan(
            Usable(columns.Width > 0.0 ? columns.Width : written.ReferenceWidth),
            Usable(columns.Gutter),
            Math.Max(columns.Count, columns.Type == StaticColumns ? 1 : 0),
            columns.IsAutoHeight ? [] : columns.Heights,
            Usable(written.DefinedHeight),
            columns.IsFlowReversed),
    };

    /// <summary>False for a text of one column, in which \N ends the line.</summary>
    public bool HasColumns => Count != 1;

    /// <summary>Infinite for a column that takes the rest.</summary>
    public double HeightOf(int column)
    {
        if (Count > 0 && column >= Count - 1) return double.PositiveInfinity;
        var height = column < Heights.Count ? Heights[column] : Height;
        return height > 0.0 ? height : double.PositiveInfinity;
    }

    /// <summary>Left side of a column, from the left side of all.</summary>
    public double LeftOf(int column, int used, double width) => (IsReversed ? Math.Max(Count, used) - 1 - column : column) * (width + Gutter);

    /// <summary>Of all columns.</summary>
    public double TotalWidth(int used, double width) => (Math.Max(Count, used) * (width + Gutter)) - Gutter;

    /// <summary>The greatest stated height; 0 when none is stated.</summary>
    public double StatedHeight(int used)
    {
        var height = Heights.Count < used || Heights.Count == 0 ? Height : 0.0;
        foreach (var stated in Heights) height = Math.Max(height, Usable(stated));
        return height;
    }

    private static ColumnPlan Single(double width) => new(Usable(width), 0.0, 1, [], 0.0, IsReversed: false);

    private static double Usable(double length) => length > 0.0 && double.IsFinite(length) ? length : 0.0;
}
