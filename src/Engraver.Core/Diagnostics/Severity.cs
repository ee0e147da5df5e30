using System.Collections.Immutable;
using System.Globalization;
using System.Text;
using Engraver.Core.Geometry;
using Engraver.Core.Languages;

namespace Engraver.Core.Diagnostics;

/// <summary>The severity of a finding. <see cref="Error"/>: the file is unusable or truncated, or a curve is lost (exit code 1).</summary>
public enum Severity
{
    Info,
    Warning,
    Error,
}
