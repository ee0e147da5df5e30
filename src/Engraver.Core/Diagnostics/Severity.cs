namespace Engraver.Core.Diagnostics;

/// <summary>How bad a finding is. <see cref="Error"/>: the file is unusable or truncated, or a curve is lost (exit code 1).</summary>
public enum Severity
{
    Info,
    Warning,
    Error,
}
