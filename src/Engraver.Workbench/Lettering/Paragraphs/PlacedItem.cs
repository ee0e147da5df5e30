namespace Engraver.Workbench.Lettering.Paragraphs;

/// <summary>An item and the place of its pen from the left side of the frame.</summary>
internal readonly record struct PlacedItem(LineItem Item, double X);
