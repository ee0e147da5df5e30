namespace Engraver.Fonts.StrokeFiles;

/// <summary>The sign of a diameter, which stroke fonts have at one of two places: that of Unicode, or that of the empty set.</summary>
internal static class DiameterSign
{
    public const int Code = 0x2300, EmptySet = 0x2205;

    /// <returns>The other place; the code itself if it is another character.</returns>
    public static int Other(int codePoint) => codePoint switch
    {
        Code => EmptySet,
        EmptySet => Code,
        _ => codePoint,
    };
}
