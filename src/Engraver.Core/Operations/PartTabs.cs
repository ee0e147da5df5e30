namespace Engraver.Core.Operations;

/// <summary>Bridges of material that hold a part until it is taken out: the tool rises over them in the deepest passes.</summary>
/// <param name="Count">For each contour, at least 1.</param>
/// <param name="Width">Of the material that remains, mm.</param>
/// <param name="Height">Above the final depth, mm.</param>
public sealed record PartTabs(int Count, double Width, double Height);
