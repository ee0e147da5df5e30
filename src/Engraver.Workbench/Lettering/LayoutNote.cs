namespace Engraver.Workbench.Lettering;

/// <summary>Something that the layout of a text reports.</summary>
/// <param name="Detail">The code, the character or the name that it concerns.</param>
public readonly record struct LayoutNote(LayoutNoteKind Kind, string Detail);
