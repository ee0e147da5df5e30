using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Tests.Commands.Reshaping;

/// <summary>Objects of a drawing as short texts, and sessions with a given drawing.</summary>
internal static class ObjectText
{
    public static CommandTestSession Talk(DrawingBuilder builder)
    {
        var talk = new CommandTestSession();
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = builder.Build() });
        return talk;
    }

    /// <summary>Every object: its type, and its parts as <c>x,y>x,y</c> (a line) or <c>x,y r5 0+90</c> (an arc, degrees), six decimals.</summary>
    public static string[] All(CommandTestSession talk) => [.. Enumerable.Range(0, talk.State.Drawing!.Entities.Count).Select(index => Of(talk.State.Drawing!, index))];

    public static string Of(Drawing drawing, int entity) => $"{drawing.Entities[entity].Type}{(drawing.Entities[entity].Closed ? " closed" : "")}: {string.Join(" | ", DrawingPick.Segments(drawing, entity).Select(Of))}";

    private static string Of(Segment segment) => segment.Kind switch
    {
        SegmentKind.Line => $"{Of(segment.Start)}>{Of(segment.End)}",
        SegmentKind.Arc or SegmentKind.Circle => $"{Of(segment.Arc.Centre)} r{Of(segment.Arc.Radius)} {Of(segment.Arc.Start.Positive().Degrees)}{(segment.Arc.Sweep.Degrees < 0.0 ? "" : "+")}{Of(segment.Arc.Sweep.Degrees)}",
        _ => $"curve {Of(segment.Start)}>{Of(segment.End)}",
    };

    private static string Of(Point2D place) => $"{Of(place.X)},{Of(place.Y)}";

    private static string Of(double value) => (Math.Round(value, 6) + 0.0).ToString("0.######", CultureInfo.InvariantCulture);
}
