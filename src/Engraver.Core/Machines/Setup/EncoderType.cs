namespace Engraver.Core.Machines.Setup;

/// <summary>How an encoder is read.</summary>
/// <param name="IsReversed">Counts decrease where they would increase.</param>
public readonly record struct EncoderType(EncoderSignal Signal, bool IsReversed);
