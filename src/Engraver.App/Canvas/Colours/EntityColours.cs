using Engraver.Core.Drawings;

namespace Engraver.App.Canvas.Colours;

/// <summary>The resolved colour of every entity as an index into a palette: 1 to 255 are the AutoCAD colour index, higher values the other colours of this
/// drawing (true colours and faded ones). Entities on a locked layer are blended half with the background, as in AutoCAD (LAYLOCKFADECTL 50).</summary>
public sealed class EntityColours
{
    private const int MaxColours = ushort.MaxValue;
    private const double FadeFactor = 0.5;

    private readonly ushort[] _indices;
    private readonly (DrawingColour Colour, bool IsFaded)[] _others;

    private EntityColours(ushort[] indices, (DrawingColour Colour, bool IsFaded)[] others) => (_indices, _others) = (indices, others);

    /// <summary>Everything in the foreground colour.</summary>
    public static EntityColours AllForeground { get; } = new([], []);

    /// <summary>Palette index of an entity; an entity beyond the last known one has the foreground colour.</summary>
    public ushort this[int entity] => entity < _indices.Length ? _indices[entity] : (ushort)AciPalette.Foreground;

    /// <summary>The colours that the drawing defines.</summary>
    public static EntityColours From(Drawing drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        return From(drawing.Entities.Count, drawing.ColourOf, drawing.Layers.Any(layer => layer.Locked) ? entity => drawing.Layers[drawing.Entities[entity].Layer].Locked : null);
    }

    /// <param name="count">Number of entities.</param>
    /// <param name="colourOf">Resolved colour of an entity.</param>
    /// <param name="isFaded">Whether an entity is faded; null: none is.</param>
    public static EntityColours From(int count, Func<int, DrawingColour> colourOf, Predicate<int>? isFaded = null)
    {
        ArgumentNullException.ThrowIfNull(colourOf);
        var indices = new ushort[count];
        var others = new Dictionary<(DrawingColour, bool), ushort>();
        for (var entity = 0; entity < count; entity++) indices[entity] = IndexOf(colourOf(entity), isFaded?.Invoke(entity) ?? false, others);
        return new EntityColours(indices, [.. others.OrderBy(pair => pair.Value).Select(pair => pair.Key)]);
    }

    /// <summary>The colour of an entity on a background, 0xAARRGGBB.</summary>
    /// <param name="isFaded">Whether the entity is on a locked layer.</param>
    public static uint Resolve(CanvasTheme theme, DrawingColour colour, bool isFaded)
    {
        ArgumentNullException.ThrowIfNull(theme);
        var full = AciPalette.ColourOf(colour, theme.Foreground);
        return isFaded ? ColourRamp.Mixed(full, theme.Background, FadeFactor) : full;
    }

    /// <summary>The colour of each palette index on a background, 0xAARRGGBB.</summary>
    public uint[] PaletteFor(CanvasTheme theme)
    {
        ArgumentNullException.ThrowIfNull(theme);
        var palette = new uint[AciPalette.Count + _others.Length];
        for (var index = 0; index < AciPalette.Count; index++) palette[index] = AciPalette.ColourOf(index, theme.Foreground);
        for (var i = 0; i < _others.Length; i++) palette[AciPalette.Count + i] = Resolve(theme, _others[i].Colour, _others[i].IsFaded);
        return palette;
    }

    private static ushort IndexOf(DrawingColour colour, bool isFaded, Dictionary<(DrawingColour, bool), ushort> others)
    {
        if (!isFaded && colour.Rgb is null) return (ushort)(colour.Index ?? AciPalette.Foreground);
        if (others.TryGetValue((colour, isFaded), out var index)) return index;
        if (AciPalette.Count + others.Count >= MaxColours) return (ushort)AciPalette.Foreground;
        return others[(colour, isFaded)] = (ushort)(AciPalette.Count + others.Count);
    }
}
