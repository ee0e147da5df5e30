namespace Engraver.Core.Drawings;

/// <summary>An entity whose geometry we could not take: a curve the operator might miss. Every one is listed, none is dropped in silence.</summary>
public sealed record RefusedEntity(string Type, string? Handle, long Line, string DiagnosticId, string Reason);
