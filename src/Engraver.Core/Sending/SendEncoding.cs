using Engraver.Core.Diagnostics;

namespace Engraver.Core.Sending;

/// <summary>The result of preparing a program for sending.</summary>
/// <param name="Job">Null when it cannot be sent.</param>
/// <param name="Refusal">The reason why it cannot be sent; null when it can.</param>
public sealed record SendEncoding(SendJob? Job, Diagnostic? Refusal);
