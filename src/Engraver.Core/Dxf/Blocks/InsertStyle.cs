using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;

namespace Engraver.Core.Dxf.Blocks;

/// <summary>Layer, visibility and colour that an INSERT passes on to the content of its block.</summary>
/// <param name="Layer">Layer of the content that is drawn on layer 0.</param>
/// <param name="Hidden">The insert, or one around it, is invisible or on a frozen layer.</param>
/// <param name="Colour">Colour of content "by block".</param>
internal readonly record struct InsertStyle(int Layer, bool Hidden, DrawingColour Colour)
{
    /// <summary>The style of an INSERT in model space, where "by block" has no reference and becomes the foreground colour.</summary>
    public static InsertStyle FromModelSpace(in BlockInsert insert) => new(insert.Layer, Hidden: false, insert.Colour.IsByBlock ? DrawingColour.Foreground : insert.Colour);

    /// <summary>The effective layer of content drawn on a layer.</summary>
    public int LayerOf(int own, LayerTable layers) => own == layers.Zero ? Layer : own;

    /// <param name="own">As written.</param>
    /// <param name="layer">The effective layer.</param>
    /// <param name="layers">Gives the present colour of a layer, needed where the insert is coloured by another layer than this one.</param>
    public DrawingColour ColourOf(DrawingColour own, int layer, LayerTable layers)
    {
        if (!own.IsByBlock) return own;
        return Colour.IsByLayer && Layer != layer ? layers.ColourOf(Layer) : Colour;
    }

    /// <summary>The style that a nested INSERT passes on.</summary>
    public InsertStyle Inside(in BlockInsert nested, LayerTable layers)
    {
        var layer = LayerOf(nested.Layer, layers);
        return this with { Layer = layer, Colour = ColourOf(nested.Colour, layer, layers) };
    }
}
