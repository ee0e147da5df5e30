namespace Engraver.Core.Drawings;

/// <summary>An entity whose geometry could not be read: a curve that may be missing from the job. Every one is listed.</summary>
public sealed record RefusedEntity(string Type, string? Handle, long Line, string DiagnosticId, string Reason);
