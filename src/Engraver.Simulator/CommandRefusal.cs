namespace Engraver.Simulator;

/// <summary>The n-th command received (from 1) is answered "?" with the given TC code (galil-dmc.md A.8) and not executed.</summary>
public readonly record struct CommandRefusal(long Command, int TcCode);
