using Engraver.Workbench.Lettering;

namespace Engraver.Workbench.LetteredDrawings;

/// <summary>A text whose letters are curves of the lettered drawing.</summary>
/// <param name="Text">Index in the texts of the drawing before.</param>
/// <param name="Entity">Index in the entities of the lettered drawing.</param>
public sealed record LetteredText(int Text, int Entity, TextLayout Layout);
