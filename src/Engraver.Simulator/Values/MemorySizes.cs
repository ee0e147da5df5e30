namespace Engraver.Simulator.Values;

/// <summary>Sizes of the controller's memory that matter while text is being received (galil-dmc.md A.6, E).</summary>
internal static class MemorySizes
{
    /// <summary>Characters in a line of a program.</summary>
    public const int LongestLine = 80;

    /// <summary>Elements of all arrays together.</summary>
    public const int ArrayElements = 8000;

    /// <summary>Characters kept of an array that is downloaded as text: 24 for each element that it can have. A longer text has too many elements in any
    /// case.</summary>
    public const int LongestArray = ArrayElements * 24;
}
