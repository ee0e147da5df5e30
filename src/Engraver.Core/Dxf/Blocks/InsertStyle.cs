using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;

namespace Engraver.Core.Dxf.Blocks;

/// <summary>Layer, visibility, colour, linetype and lineweight that an INSERT passes on to the content of its block.</summary>
/// <param name="Layer">Layer of the content that is drawn on layer 0.</param>
/// <param name="Hidden">The insert, or one around it, is invisible or on a frozen layer.</param>
/// <param name="Colour">Colour of content "by block".</param>
/// <param name="Linetype">Linetype of content "by block".</param>
/// <param name="Path">Its block, and those around it: number of a <see cref="BlockPath"/>.</param>
internal readonly record struct InsertStyle(int Layer, bool Hidden, DrawingColour Colour, int Linetype, int Path)
{
    /// <summary>Number of the insert whose content it is; 0 for none.</summary>
    public int Insert { get; init; }

    /// <summary>Lineweight of content "by block".</summary>
    public int Lineweight { get; init; }

    /// <summary>The style of an INSERT in model space, where "by block" has no reference and becomes the foreground colour.</summary>
    public static InsertStyle FromModelSpace(in BlockInsert insert, BlockPathTable paths) => new(
        insert.Layer, Hidden: false, insert.Colour.IsByBlock ? DrawingColour.Foreground : insert.Colour,
        insert.Linetype == Drawings.Linetype.ByBlock ? Drawings.Linetype.Continuous : insert.Linetype, paths.Inside(0, insert.Block))
    {
        Lineweight = insert.Lineweight == Drawings.Lineweight.ByBlock ? Drawings.Lineweight.Default : insert.Lineweight,
    };

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

    /// <summary>As <see cref="ColourOf"/>, for a linetype.</summary>
    public int LinetypeOf(int own, int layer, LayerTable layers)
    {
        if (own != Drawings.Linetype.ByBlock) return own;
        return Linetype == Drawings.Linetype.ByLayer && Layer != layer ? layers.LinetypeOf(Layer) : Linetype;
    }

    /// <summary>As <see cref="ColourOf"/>, for a lineweight.</summary>
    public int LineweightOf(int own, int layer, LayerTable layers)
    {
        if (own != Drawings.Lineweight.ByBlock) return own;
        return Lineweight == Drawings.Lineweight.ByLayer && Layer != layer ? layers.LineweightOf(Layer) : Lineweight;
    }

    /// <summary>The style that a nested INSERT passes on.</summary>
    public InsertStyle Inside(in BlockInsert nested, LayerTable layers, BlockPathTable paths)
    {
        var layer = LayerOf(nested.Layer, layers);
        return this with { Layer = layer, Colour = ColourOf(nested.Colour, layer, layers), Linetype = LinetypeOf(nested.Linetype, layer, layers), Lineweight = LineweightOf(nested.Lineweight, layer, layers), Path = paths.Inside(Path, nested.Block) };
    }
}
