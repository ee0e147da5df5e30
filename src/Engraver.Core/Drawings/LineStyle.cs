namespace Engraver.Core.Drawings;

/// <summary>How the line of an entity is drawn.</summary>
/// <param name="Linetype">Index into <see cref="Drawing.Linetypes"/>, as stated; inside blocks "by block" is resolved.</param>
/// <param name="Scale">Group 48: scale of the pattern of the entity, above 0.</param>
/// <param name="RunsThrough">Flag 128 of a polyline: the pattern runs through its vertices, otherwise it begins at each of them.</param>
public readonly record struct LineStyle(int Linetype, double Scale, bool RunsThrough)
{
    /// <summary>Lineweight as stated, hundredths of a millimetre or one of <see cref="Drawings.Lineweight"/>; inside blocks "by block" is resolved.</summary>
    public int Lineweight { get; init; } = Drawings.Lineweight.ByLayer;

    /// <summary>Constant width of a polyline, drawing units; 0 for none, NaN for one that varies.</summary>
    public double Width { get; init; }

    /// <summary>The style of an entity that states nothing; the first one of every drawing.</summary>
    public static LineStyle ByLayer { get; } = new(Drawings.Linetype.ByLayer, 1.0, false);
}
