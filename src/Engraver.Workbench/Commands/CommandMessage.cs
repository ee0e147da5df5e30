namespace Engraver.Workbench.Commands;

/// <summary>A line of the command window's history.</summary>
public sealed record CommandMessage(MessageKind Kind, string Text);
