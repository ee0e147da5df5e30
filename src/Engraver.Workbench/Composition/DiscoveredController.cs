namespace Engraver.Workbench.Composition;

/// <summary>Result of a query.</summary>
/// <param name="Model">Model reported by the controller; null if none answers.</param>
/// <param name="Serial">Its serial number; null if it has none.</param>
/// <param name="Failure">Why no controller was found; null if one answers.</param>
public sealed record DiscoveredController(string Address, string? Model, long? Serial, string? Failure);
