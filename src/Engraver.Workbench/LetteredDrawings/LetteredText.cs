using Engraver.Workbench.Lettering;

namespace Engraver.Workbench.LetteredDrawings;

/// <summary>A text whose letters are curves of the lettered drawing.</summary>
/// <param name="Entity">Index in the entities of the lettered drawing.</param>
public sealed record LetteredText(int Entity, TextLayout Layout);
