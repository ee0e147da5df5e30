using Engraver.Simulator.Language;
using Engraver.Simulator.Motion;

namespace Engraver.Simulator.Commands;

/// <summary>A setting that every axis has, readable as <c>_XXa</c>, <c>XX ?</c> and <c>XXa=?</c>.</summary>
/// <param name="Write">Null when it can only be read.</param>
/// <param name="Format">How queries print it; null is the position format PF.</param>
internal sealed record AxisParameter(
    string Mnemonic,
    Func<Axis, FixedPoint> Read,
    Action<Machine, Axis, FixedPoint>? Write,
    NumberFormat? Format = null);
