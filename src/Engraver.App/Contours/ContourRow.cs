using System.Globalization;
using Engraver.App.Texts;
using Engraver.Core.Sequencing;

namespace Engraver.App.Contours;

/// <summary>A contour in cutting order.</summary>
public sealed class ContourRow(SequencedStroke stroke) : IEquatable<ContourRow>
{
    public int Index => stroke.Index;

    public string Number => (stroke.Index + 1).ToString(CultureInfo.InvariantCulture);

    public string Kind => Text.Get(stroke.Closed ? "Contours.Closed" : "Contours.Open");

    public bool IsOpen => !stroke.Closed;

    public string Segments => stroke.Segments.ToString(CultureInfo.InvariantCulture);

    public string Length => stroke.Length.ToString("0.###", CultureInfo.InvariantCulture);

    /// <summary>Number of the enclosing contour; empty for none.</summary>
    public string Inside => stroke.Inside < 0 ? "" : (stroke.Inside + 1).ToString(CultureInfo.InvariantCulture);

    /// <summary>An arrow: the sense of a closed contour (counter-clockwise or clockwise), the direction of an open one.</summary>
    public string Direction => stroke.Closed ? (SignedArea() >= 0.0 ? "↺" : "↻") : "→";

    public bool Equals(ContourRow? other) => other is not null && other.Index == Index;

    public override bool Equals(object? obj) => Equals(obj as ContourRow);

    public override int GetHashCode() => Index;

    /// <summary>Twice the area, by chords of quarter moves, because a circle is one move and would otherwise have no area.</summary>
    private double SignedArea()
    {
        const int Parts = 4;
        var area = 0.0;
        foreach (var move in stroke.Moves)
        {
            var from = move.Segment.Start;
            for (var part = 1; part <= Parts; part++)
            {
                var to = move.Segment.PointAt((double)part / Parts);
                area += (from.X * to.Y) - (to.X * from.Y);
                from = to;
            }
        }

        return area;
    }
}
