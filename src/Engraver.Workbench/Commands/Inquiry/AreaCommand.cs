using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Inquiry;

/// <summary>AREA: Measures area and perimeter of a polygon of points, or of closed objects.</summary>
internal sealed class AreaCommand : ICommand
{
    public CommandInfo Info { get; } = new("AREA", CommandGroup.Ask) { IsAllowedDuringJob = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var first = await context.AskAsync(new PointPrompt(Wording.Get("Area.SpecifyFirstCornerPoint")) { Options = Keyword.List("Object"), Default = "Object" }).ConfigureAwait(false);
        if (first is Answer<Point2D>.Value { Result: var corner }) await PolygonAsync(context, corner).ConfigureAwait(false);
        else await ObjectsAsync(context).ConfigureAwait(false);
    }

    private static async Task PolygonAsync(CommandContext context, Point2D first)
    {
        var corners = new List<Point2D> { first };
        while (await context.AskAsync(new PointPrompt(Wording.Get("Area.SpecifyNextPointOrTotal")) { EnterEnds = true, From = corners[^1] }).ConfigureAwait(false) is Answer<Point2D>.Value { Result: var next }) corners.Add(next);
        var sides = corners.Select((corner, i) => Segment.FromLine(corner, corners[(i + 1) % corners.Count])).ToList();
        WriteArea(context, ClosedArea.Measure(sides), sides.Sum(side => side.Length), Wording.Get("Area.Perimeter"));
    }

    private static async Task ObjectsAsync(CommandContext context)
    {
        var drawing = context.Drawing;
        foreach (var index in await ObjectSelection.GetAsync(context).ConfigureAwait(false))
        {
            var segments = Segments(drawing, index);
            var isRound = segments is [{ Kind: SegmentKind.Circle }];
            WriteArea(context, ClosedArea.Measure(segments), segments.Sum(segment => segment.Length), isRound ? Wording.Get("Area.Circumference") : segments[0].Start == segments[^1].End ? Wording.Get("Area.Perimeter") : Wording.Get("Area.Length"));
        }
    }

    private static List<Segment> Segments(Drawing drawing, int index)
    {
        var entity = drawing.Entities[index];
        return [.. Enumerable.Range(entity.FirstPart, entity.PartCount).Select(part => drawing.SegmentOf(drawing.Parts[part]))];
    }

    private static void WriteArea(CommandContext context, double area, double length, string word) => context.WriteMessage(Wording.Get("Area.Area", context.Precision.FormatArea(area), word, context.Precision.FormatLength(length)), MessageKind.Result);
}
