namespace Engraver.Core.Diagnostics;

/// <summary>The severity of a finding. <see cref="Error"/>: the file is unusable or truncated, or a curve is lost (exit code 1).</summary>
public enum Severity
{
    Info,
    Warning,
    Error,
}
