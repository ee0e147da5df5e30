namespace Engraver.Workbench.Commands.Properties;

/// <summary>A property and the common value of the selected objects, or <see cref="ObjectProperties.Varies"/>.</summary>
/// <param name="IsEditable">It can be changed for all of them.</param>
/// <param name="Exists">All of them have it.</param>
public sealed record PropertyValue(ObjectProperty Property, string Value, bool IsEditable, bool Exists = true);
