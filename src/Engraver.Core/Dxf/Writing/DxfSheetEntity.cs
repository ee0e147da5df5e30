using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Writing;

/// <summary>A curve of a written drawing: a segment with its direction, its layer, and extended data for the reader of this package.</summary>
/// <param name="Segment">In the unit of the sheet; written so that it reads back with this start, end and direction.</param>
/// <param name="Layer">Name of one of the sheet's layers.</param>
/// <param name="Role">First text of the extended data; null for no extended data.</param>
/// <param name="Sequence">Place in the order of cutting, 1 is first; 0 for an entity that is not cut.</param>
/// <param name="Stroke">The stroke it belongs to or leads to, 1 is first.</param>
public readonly record struct DxfSheetEntity(Segment Segment, string Layer, string? Role, int Sequence, int Stroke)
{
    /// <summary>All segments of a polyline, lines and arcs end to start; null for a segment alone.</summary>
    public IReadOnlyList<Segment>? Run { get; init; }

    /// <summary>The polyline is a closed one: its last segment ends where the first begins.</summary>
    public bool Closed { get; init; }

    /// <summary>Heights (z) of a line's ends; an arc, a circle and a polyline are at the first. Ellipses and splines have their own.</summary>
    public (double Start, double End) Z { get; init; }

    /// <summary>Heights of the vertices of a polyline of lines that is not level; null for every other entity.</summary>
    public IReadOnlyList<double>? Heights { get; init; }

    /// <summary>Number of handles that it needs: the vertices and the end of a polyline in space have their own handles.</summary>
    internal int Handles => Heights is null ? 1 : Heights.Count + 2;

    /// <summary>The source entity in the drawing, for a finding about it; default for none.</summary>
    public SourceRef Source { get; init; }

    public DrawingColour Colour { get; init; }

    /// <summary>Name of its linetype; null for by layer.</summary>
    public string? Linetype { get; init; }

    /// <summary>Scale of the pattern of its linetype.</summary>
    public double? LinetypeScale { get; init; }

    /// <summary>Group 370; null for by layer.</summary>
    public int? Lineweight { get; init; }

    /// <summary>Constant width of a polyline; 0 for none.</summary>
    public double Width { get; init; }

    /// <summary>The pattern of a polyline runs through its vertices.</summary>
    public bool RunsThrough { get; init; }

    /// <summary>The inserts from which it comes, the outermost first; null or empty for none. The reader of this package restores them.</summary>
    public IReadOnlyList<DxfSheetInsert>? Inserts { get; init; }

    /// <summary>Written as invisible (code 60).</summary>
    public bool Hidden { get; init; }

    public IReadOnlyList<Segment> Segments => Run ?? [Segment];
}
