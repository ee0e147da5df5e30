namespace Engraver.Simulator;

/// <summary>The link of a handle (0 = A) is cut after this many commands on it; the controller continues to run.</summary>
public readonly record struct HandleDrop(int Handle, long AfterCommands);
