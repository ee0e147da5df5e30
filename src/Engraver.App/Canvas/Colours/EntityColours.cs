using Engraver.Core.Drawings;

namespace Engraver.App.Canvas.Colours;

/// <summary>The resolved colour of every entity as an index into a palette: 1 to 255 are the AutoCAD colour index, higher ones the true colours of this drawing.</summary>
public sealed class EntityColours
{
    private const int MostColours = ushort.MaxValue;
    private readonly ushort[] _indices;
    private readonly uint[] _trueColours;

    private EntityColours(ushort[] indices, uint[] trueColours) => (_indices, _trueColours) = (indices, trueColours);

    /// <summary>Everything in the foreground colour.</summary>
    public static EntityColours White { get; } = new([], []);

    /// <summary>Palette index of an entity; an entity beyond the last known one has the foreground colour.</summary>
    public ushort this[int entity] => entity < _indices.Length ? _indices[entity] : (ushort)AciPalette.Foreground;

    /// <summary>The colours that the drawing states.</summary>
    public static EntityColours From(Drawing drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        return From(drawing.Entities.Count, drawing.ColourOf);
    }

    /// <param name="count">Number of entities.</param>
    /// <param name="colourOf">Resolved colour of an entity.</param>
    public static EntityColours From(int count, Func<int, DrawingColour> colourOf)
    {
        ArgumentNullException.ThrowIfNull(colourOf);
        var indices = new ushort[count];
        var known = new Dictionary<uint, ushort>();
        for (var entity = 0; entity < count; entity++) indices[entity] = IndexOf(colourOf(entity), known);
        return new EntityColours(indices, [.. known.OrderBy(pair => pair.Value).Select(pair => pair.Key)]);
    }

    /// <summary>The colour of each palette index on a background, 0xAARRGGBB.</summary>
    /// <param name="foreground">0xAARRGGBB of index 7.</param>
    public uint[] PaletteFor(uint foreground)
    {
        var palette = new uint[AciPalette.Count + _trueColours.Length];
        for (var index = 0; index < AciPalette.Count; index++) palette[index] = AciPalette.ColourOf(index, foreground);
        for (var i = 0; i < _trueColours.Length; i++) palette[AciPalette.Count + i] = 0xFF000000 | _trueColours[i];
        return palette;
    }

    private static ushort IndexOf(DrawingColour colour, Dictionary<uint, ushort> known)
    {
        if (colour.Rgb is not { } rgb) return (ushort)(colour.Index ?? AciPalette.Foreground);
        if (known.TryGetValue(rgb, out var index)) return index;
        if (AciPalette.Count + known.Count >= MostColours) return (ushort)AciPalette.Foreground;
        return known[rgb] = (ushort)(AciPalette.Count + known.Count);
    }
}
