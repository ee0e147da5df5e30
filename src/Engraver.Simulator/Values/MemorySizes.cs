namespace Engraver.Simulator.Values;

/// <summary>Sizes of the controller's memory that the protocol has to know while text arrives (galil-dmc.md A.6, E).</summary>
internal static class MemorySizes
{
    /// <summary>Characters in a line of a program.</summary>
    public const int LongestLine = 80;

    /// <summary>Elements of all arrays together.</summary>
    public const int ArrayElements = 8000;

    /// <summary>Characters of a program, or of an array as text, that are kept for one line or array: 24 for each element that an array can have; a text beyond it holds too many.</summary>
    public const int LongestArray = ArrayElements * 24;
}
