using Engraver.Core.Machines;
using Engraver.Simulator;

namespace Engraver.Workbench.Composition;

/// <summary>Settings of a <see cref="ServedSimulator"/>; <see cref="SimulatorOptions"/> describes the switches with the same names.</summary>
/// <param name="Speed">Controller seconds per wall-clock second; infinity is virtual time.</param>
public sealed record ServedSimulatorSettings(double Speed)
{
    /// <summary>Speeds, accelerations and angle quantum are used as burned values, travel and homing define the switches, other fields are ignored; null for
    /// the factory state.</summary>
    public MachineProfile? Profile { get; init; }

    /// <summary>Planned faults as JSON (docs/simulator-fidelity.md); null for none.</summary>
    public string? Faults { get; init; }

    /// <summary>In messages only the sign column separates a negative number from the previous one.</summary>
    public bool SignColumn { get; init; }

    /// <summary>The serial number that _BN returns; null for a random one.</summary>
    public int? SerialNumber { get; init; }

    /// <inheritdoc cref="SimulatorOptions.EarlyRamps"/>
    public bool EarlyRamps { get; init; }

    /// <inheritdoc cref="SimulatorOptions.OnePendingExit"/>
    public bool OnePendingExit { get; init; }

    /// <inheritdoc cref="SimulatorOptions.OwnEntrySpeed"/>
    public bool OwnEntrySpeed { get; init; }

    /// <inheritdoc cref="SimulatorOptions.DecodeTime"/>
    public TimeSpan DecodeTime { get; init; }
}
