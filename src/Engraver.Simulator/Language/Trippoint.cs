namespace Engraver.Simulator.Language;

/// <summary>A condition that a thread waits for. <paramref name="AtSample"/> is the sample of release when it is known in advance.</summary>
internal sealed record Trippoint(Func<bool> IsReleased, long? AtSample = null);
