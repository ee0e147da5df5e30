namespace Engraver.App.Properties;

/// <summary>A name and its value.</summary>
/// <param name="IsHead">True: the beginning of an object.</param>
public sealed record PropertyLine(string Name, string Value, bool IsHead = false);
