namespace Engraver.Core.Machines.Origins;

/// <summary>The names of work origins, as in G-code.</summary>
public static class WorkOriginNames
{
    public const string First = "G54";

    /// <summary>In the order in which they are listed.</summary>
    public static IReadOnlyList<string> All { get; } = [First, "G55", "G56", "G57", "G58", "G59"];

    /// <summary>The name in its standard spelling, for a text in any case; null when the text is not a name.</summary>
    public static string? Find(string text) => All.FirstOrDefault(name => name.Equals(text, StringComparison.OrdinalIgnoreCase));
}
