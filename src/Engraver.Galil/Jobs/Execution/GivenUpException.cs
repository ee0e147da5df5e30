namespace Engraver.Galil.Jobs.Execution;

/// <summary>The motion of a held job was given up: nothing is in progress in the controller, and the axes may be moved. It ends the strategy and not the
/// job, which catches it in one place.</summary>
internal sealed class GivenUpException : Exception;
