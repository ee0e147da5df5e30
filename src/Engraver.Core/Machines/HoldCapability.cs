namespace Engraver.Core.Machines;

/// <summary>How a job is held.</summary>
/// <param name="SwitchesToolOff">The tool is off during a hold, and on again before the job resumes.</param>
public sealed record HoldCapability(bool SwitchesToolOff);
