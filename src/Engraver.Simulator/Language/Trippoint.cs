namespace Engraver.Simulator.Language;

/// <summary>What a thread waits for. <paramref name="AtSample"/> is the sample of release when it is known beforehand.</summary>
internal sealed record Trippoint(Func<bool> IsReleased, long? AtSample = null);
