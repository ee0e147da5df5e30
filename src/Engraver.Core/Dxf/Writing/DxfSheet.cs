using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Writing;

/// <summary>The input of <see cref="DxfWriter"/>: layers, and curves in order, in one unit.</summary>
/// <param name="Layers">Layer 0 is written in colour 7 when it is not among them.</param>
/// <param name="Entities">In file order.</param>
public sealed record DxfSheet(IReadOnlyList<DxfSheetLayer> Layers, IReadOnlyList<DxfSheetEntity> Entities)
{
    /// <summary>$INSUNITS, 1 to 24.</summary>
    public int InsUnits { get; init; } = 4;

    /// <summary>Written after the curves.</summary>
    public IReadOnlyList<DxfSheetText> Texts { get; init; } = [];

    /// <summary>Written after the texts.</summary>
    public IReadOnlyList<DxfSheetPoint> Points { get; init; } = [];

    /// <summary>Linetypes besides the three that every drawing has.</summary>
    public IReadOnlyList<Linetype> Linetypes { get; init; } = [];

    /// <summary>$LTSCALE; 1 is not written.</summary>
    public double LinetypeScale { get; init; } = 1.0;

    /// <summary>Text styles of the drawing; one that a text names is written even if it is not among them.</summary>
    public IReadOnlyList<TextStyle> TextStyles { get; init; } = [];

    /// <summary>The text styles that are written, Standard first.</summary>
    internal IReadOnlyList<TextStyle> Styles =>
        [.. TextStyles.Concat(Texts.Select(text => new TextStyle(text.Text.Style) { FontFile = text.Text.Font })).Append(new TextStyle("Standard")).DistinctBy(style => style.Name, StringComparer.OrdinalIgnoreCase).OrderBy(style => !style.Name.Equals("Standard", StringComparison.OrdinalIgnoreCase))];

    /// <summary>The handle under which each of <see cref="Entities"/> is written.</summary>
    public IReadOnlyList<string> EntityHandles
    {
        get
        {
            var (handles, next) = (new string[Entities.Count], DxfHandles.FirstEntityOf(this));
            for (var i = 0; i < handles.Length; i++, next += Entities[i - 1].Handles) handles[i] = next.ToString("X", CultureInfo.InvariantCulture);
            return handles;
        }
    }

    /// <summary>The handle under which each of <see cref="Points"/> is written.</summary>
    public IReadOnlyList<string> PointHandles
    {
        get
        {
            var first = DxfHandles.FirstEntityOf(this) + Entities.Sum(entity => entity.Handles) + Texts.Count;
            return [.. Enumerable.Range(first, Points.Count).Select(handle => handle.ToString("X", CultureInfo.InvariantCulture))];
        }
    }

    internal int Handles => Entities.Sum(entity => entity.Handles) + Texts.Count + Points.Count;

    internal bool HasTrueColours => Layers.Any(layer => layer.Rgb is not null) || Entities.Any(entity => entity.Colour.Rgb is not null) || Texts.Any(text => text.Text.Colour.Rgb is not null) || Points.Any(point => point.Point.Colour.Rgb is not null);

    /// <summary>Smallest box of the curves; empty when there are none.</summary>
    public Bounds2D Bounds => Entities.Aggregate(Bounds2D.Empty, (box, entity) => entity.Segments.Aggregate(box, (all, segment) => all.Union(segment.Bounds)));
}
