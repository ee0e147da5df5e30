namespace Engraver.Core.Machines;

/// <summary>A command that the controller refused.</summary>
/// <param name="Code">The controller's number for the reason; compare this and not the text.</param>
/// <param name="Text">The controller's text for the reason.</param>
/// <param name="Command">The refused command.</param>
/// <param name="Message">For the operator: what was refused, why, and the consequence here.</param>
public sealed record MachineRefusal(int Code, string Text, string Command, string Message);
