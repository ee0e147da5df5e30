using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Documents;

/// <summary>Decides what happens to the texts of a drawing when its curves are edited. Texts cannot be selected: they move with an edit of every visible curve, and otherwise stay where they are.</summary>
internal static class EditedTexts
{
    /// <summary>The texts that an edit of these curves takes along: all when it takes all curves, those that can be seen when it takes all that can be seen.</summary>
    /// <param name="selected">Indices of curves.</param>
    public static IReadOnlyList<PlacedText> Along(Drawing drawing, IReadOnlyList<int> selected)
    {
        if (drawing.Texts.Count == 0) return [];
        var taken = selected.ToHashSet();
        if (taken.Count == drawing.Entities.Count) return drawing.Texts;
        return DrawingPick.Visible(drawing).All(taken.Contains) ? [.. drawing.Texts.Where(text => IsVisible(drawing, text))] : [];
    }

    /// <summary>The texts after those that go along have moved.</summary>
    public static IReadOnlyList<PlacedText> Moved(Drawing drawing, IReadOnlyList<PlacedText> along, Transform2D map)
    {
        var moving = along.ToHashSet(ReferenceEqualityComparer.Instance);
        return moving.Count == 0 ? drawing.Texts : [.. drawing.Texts.Select(text => moving.Contains(text) ? Placed(text, map) : text)];
    }

    /// <summary>The texts with a copy of those that go along for each map; copies have no handle.</summary>
    public static IReadOnlyList<PlacedText> Copied(Drawing drawing, IReadOnlyList<PlacedText> along, IReadOnlyList<Transform2D> maps) =>
        [.. drawing.Texts, .. maps.SelectMany(map => along.Select(text => Placed(text, map) with { Handle = 0 }))];

    /// <summary>The texts without those that go along.</summary>
    public static IReadOnlyList<PlacedText> Without(Drawing drawing, IReadOnlyList<PlacedText> along) => [.. drawing.Texts.Except<PlacedText>(along, ReferenceEqualityComparer.Instance)];

    /// <summary>A mirrored text reads from the back, as what is engraved of a mirrored drawing does.</summary>
    private static PlacedText Placed(PlacedText text, Transform2D map) => text with
    {
        Position = At(text.Position, map),
        End = text.End is { } end ? At(end, map) : null,
        Height = text.Height * map.Scale,
        FrameWidth = text.FrameWidth * map.Scale,
        Rotation = (map.Mirrored ? map.Turn - text.Rotation : map.Turn + text.Rotation).Positive(),
        Mirrored = text.Mirrored ^ map.Mirrored,
    };

    private static Vector3D At(Vector3D place, Transform2D map)
    {
        var moved = map.Apply(new Point2D(place.X, place.Y));
        return new Vector3D(moved.X, moved.Y, place.Z);
    }

    private static bool IsVisible(Drawing drawing, PlacedText text) => !text.Hidden && drawing.Layers[text.Layer] is { On: true, Frozen: false };
}
