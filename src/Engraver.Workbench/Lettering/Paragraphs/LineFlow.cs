namespace Engraver.Workbench.Lettering.Paragraphs;

/// <summary>The lines of a text below each other and in columns.</summary>
internal sealed class LineFlow
{
    /// <summary>A baseline may pass the bottom of a column by this part of the line's height: heights in files are rounded.</summary>
    private const double Tolerance = 1e-6;

    private readonly List<FlowedLine> _lines = [];

    public IReadOnlyList<FlowedLine> Lines => _lines;

    /// <summary>Columns with at least one line.</summary>
    public int Columns { get; private set; }

    /// <summary>From the top to the bottom of the box of the text.</summary>
    public double Height { get; private set; }

    public static LineFlow Of(IEnumerable<SetLine> lines, ColumnPlan plan, LineSpacing spacing)
    {
        var flow = new LineFlow();
        var (column, y, above) = (0, 0.0, default(SetLine));
        foreach (var line in lines)
        {
            if (above is { End: SetLineEnd.ColumnBreak } && plan.HasColumns) (column, above) = (column + 1, null);
            if (above is not null)
            {
                var next = y - spacing.Between(above, line);
                if (-next > plan.HeightOf(column) + (Tolerance * line.Height)) (column, above) = (column + 1, null);
                else y = next;
            }

            if (above is null) y = -spacing.First(line);
            flow._lines.Add(new FlowedLine(line, column, y));
            flow.Height = Math.Max(flow.Height, spacing.Last(line) - y);
            above = line;
        }

        flow.Columns = column + 1;
        return flow;
    }
}
