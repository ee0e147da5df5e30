using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;

namespace Engraver.Core.Dxf.Blocks;

/// <summary>What an INSERT hands down to the content of its block.</summary>
/// <param name="Layer">The layer that counts: for content on layer 0.</param>
/// <param name="Hidden">It, or one around it, is invisible or on a frozen layer.</param>
/// <param name="Colour">For content that is coloured by block; by layer: that of <paramref name="Layer"/>.</param>
internal readonly record struct InsertStyle(int Layer, bool Hidden, DrawingColour Colour)
{
    /// <summary>Of an INSERT in model space, where nothing is around it that "by block" could mean.</summary>
    public static InsertStyle OfModelSpace(in BlockInsert insert) => new(insert.Layer, Hidden: false, insert.Colour.IsByBlock ? DrawingColour.Foreground : insert.Colour);

    /// <summary>The layer that counts for content drawn on a layer.</summary>
    public int LayerOf(int own, LayerTable layers) => own == layers.Zero ? Layer : own;

    /// <param name="own">As written.</param>
    /// <param name="layer">The layer that counts.</param>
    /// <param name="layers">Where the insert is coloured by a layer that is not this one, the layer's colour is taken as it is now.</param>
    public DrawingColour ColourOf(DrawingColour own, int layer, LayerTable layers)
    {
        if (!own.IsByBlock) return own;
        return Colour.IsByLayer && Layer != layer ? layers.ColourOf(Layer) : Colour;
    }

    /// <summary>What a nested INSERT hands down.</summary>
    public InsertStyle Inside(in BlockInsert nested, LayerTable layers)
    {
        var layer = LayerOf(nested.Layer, layers);
        return this with { Layer = layer, Colour = ColourOf(nested.Colour, layer, layers) };
    }
}
