namespace Engraver.Galil.Programs;

/// <summary>One stroke: rapid to <see cref="Start"/> with the tool off, tool on, every sequence in order (a standstill between two of them), tool off.</summary>
public sealed record MotionStroke(int Index, CountsPoint Start, IReadOnlyList<VectorSequence> Sequences);
