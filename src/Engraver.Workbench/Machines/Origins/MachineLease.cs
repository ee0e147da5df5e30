using System.Text.Json;
using System.Text.Json.Serialization;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Machines.Origins;

/// <summary>A machine leased by this host, with its state that is stored between sessions. Disposing releases it.</summary>
public sealed class MachineLease : IDisposable
{
    private readonly Lock _guard = new();
    private readonly string? _path;
    private readonly string _name = "";
    private readonly MachineLock? _lock;
    private StoredMachineState _memory = StoredMachineState.Empty;
    private bool _isZeroKnown;
    private bool _isWritten = true;

    /// <summary>A machine without stored state.</summary>
    internal MachineLease()
    {
    }

    /// <exception cref="IOException">The file cannot be read, or is invalid.</exception>
    internal MachineLease(string path, string name, MachineLock taken)
    {
        (_path, _name, _lock) = (path, name, taken);
        try
        {
            if (File.Exists(path)) _memory = MachineMemoryDocument.Read(File.ReadAllText(path)).ToMemory();
        }
        catch (Exception unusable) when (unusable is JsonException or InvalidDataException or IOException or UnauthorizedAccessException)
        {
            taken.Dispose(); // Releases the machine.
            if (unusable is JsonException) throw new InvalidDataException(Wording.Get("Origins.InvalidRecord", SystemErrorText.FromException(unusable)), unusable);
            throw;
        }
    }

    /// <summary>Whether the state is stored beyond this session.</summary>
    public bool IsPersistent => _path is not null;

    public StoredMachineState Memory
    {
        get
        {
            lock (_guard) return _memory;
        }
    }

    /// <summary>Updates the known state of the machine. If it cannot be written, it is kept in memory and written with the next change.</summary>
    /// <returns>Why it could not be written; null on success.</returns>
    public string? Update(Func<StoredMachineState, StoredMachineState> change)
    {
        ArgumentNullException.ThrowIfNull(change);
        lock (_guard)
        {
            (var before, _memory) = (_memory, change(_memory));
            return _memory == before && _isWritten ? null : Write(_memory);
        }
    }

    /// <summary>Stores a decision of the operator: if it cannot be written, nothing is changed.</summary>
    /// <returns>Why it could not be written; null on success.</returns>
    public string? Commit(Func<StoredMachineState, StoredMachineState> change)
    {
        ArgumentNullException.ThrowIfNull(change);
        lock (_guard)
        {
            var next = change(_memory);
            if (Write(next) is { } failure) return failure;
            _memory = next;
            return null;
        }
    }

    private string? Write(StoredMachineState memory)
    {
        if (_path is null) return null;
        try
        {
            OutputFile.Write(_path, output => output.WriteLine(MachineMemoryDocument.From(_name, memory).WithChecksum().ToJson()));
            _isWritten = true;
            return null;
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            _isWritten = false;
            return SystemErrorText.FromException(failure);
        }
    }

    /// <summary>True if the controller's zero is the stored one. Otherwise motion is not recorded, because it is unrelated to the stored zero.</summary>
    public bool IsZeroKnown
    {
        get
        {
            lock (_guard) return _isZeroKnown;
        }
    }

    /// <summary>True if the machine was homed by this profile and the controller's zero is unchanged as far as known.</summary>
    public bool IsHomed(MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(profile);
        lock (_guard) return _isZeroKnown && _memory.Lost.Length == 0 && _memory.WasHomedBy(profile);
    }

    /// <summary>For a simulated machine without stored state: it counts as homed, with its zero at the start position
    /// (<see cref="StoredMachineState.AssumeHomed"/>).</summary>
    /// <exception cref="InvalidOperationException">The machine has stored state.</exception>
    public void AssumeHomed(MachineProfile profile)
    {
        if (IsPersistent) throw new InvalidOperationException("A real machine is homed.");
        Update(memory => memory.AssumeHomed(profile));
    }

    /// <summary>For a simulated machine without stored state: work origins that are not set are at its start position.</summary>
    /// <param name="hasHeight">The machine has a Z axis.</param>
    /// <exception cref="InvalidOperationException">The machine has stored state.</exception>
    public void AssumeOrigins(IEnumerable<string> names, bool hasHeight)
    {
        if (IsPersistent) throw new InvalidOperationException("The origins of a real machine are set.");
        Update(memory => names.Where(name => !memory.Origins.ContainsKey(name)).Aggregate(memory, (assumed, name) => assumed.AssumeZero(name, hasHeight)));
    }

    /// <summary>Processes a position query of the controller.</summary>
    public void CompareZero(ControllerPosition place)
    {
        ArgumentNullException.ThrowIfNull(place);
        lock (_guard) _isZeroKnown = _path is null || _memory.IsSameZero(place);
        if (place.Doubt.Length > 0) NotePositionLost(place.Doubt);
        NoteAbruptStop(place, place.StoppedWithoutRamp);
    }

    /// <summary>Steppers that were stopped without deceleration since the last standstill may have lost steps.</summary>
    /// <param name="place">Current position.</param>
    /// <param name="stoppedHard">Letters of the axes that were stopped like this.</param>
    public void NoteAbruptStop(ControllerPosition place, string stoppedHard)
    {
        if (IsZeroKnown && Memory.StepLossReason(place, stoppedHard) is { Length: > 0 } why) NotePositionLost(why);
    }

    /// <summary>Marks the position of a machine with origins or homing as unknown until an origin is set again or the machine is homed.</summary>
    /// <param name="why">For example "the stepper motor of axis A is off".</param>
    public void NotePositionLost(string why)
    {
        var memory = Memory;
        if (memory.Lost.Length == 0 && (memory.Origins.Count > 0 || memory.HomedAs.Length > 0)) Update(before => before with { Lost = why });
    }

    /// <summary>Records that the machine is about to move: its position is unknown until it is reported again.</summary>
    /// <returns>Why it could not be written; null on success.</returns>
    public string? NoteMoving() => IsZeroKnown ? Update(memory => memory with { IsMoving = true }) : null;

    /// <summary>Records a reported position, at rest or moving, regardless of what moved the machine.</summary>
    public void NotePosition(CountsPoint at, bool moves)
    {
        var memory = Memory;
        if (!IsZeroKnown || (moves ? memory.IsMoving : !memory.IsMoving && memory.RestPosition == at)) return;
        Update(before => before with { IsMoving = moves, RestPosition = moves ? before.RestPosition : at });
    }

    /// <summary>Records the end of a motion of this program. If its end is unknown, the zero must be checked again before anything is recorded relative to it;
    /// if nothing was sent, nothing has changed.</summary>
    /// <returns>Why it could not be written; null on success.</returns>
    public string? NoteMotionEnd(JobResult result)
    {
        ArgumentNullException.ThrowIfNull(result);
        var rest = result.IsEndKnown ? result.FinalPosition : null;
        var isUntouched = result.IsEndKnown && rest is null;
        lock (_guard)
        {
            var knew = _isZeroKnown;
            if (rest is null && !isUntouched) _isZeroKnown = false;
            return Update(memory => (!knew ? memory : isUntouched ? memory with { IsMoving = false } : memory with { IsMoving = rest is null, RestPosition = rest }) with { Lost = result.PositionDoubt.Length > 0 ? result.PositionDoubt : memory.Lost });
        }
    }

    public void Dispose() => _lock?.Dispose();
}

[JsonSourceGenerationOptions(PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase, WriteIndented = true, DefaultIgnoreCondition = JsonIgnoreCondition.WhenWritingNull, RespectNullableAnnotations = true, UnmappedMemberHandling = JsonUnmappedMemberHandling.Skip)]
[JsonSerializable(typeof(MachineMemoryDocument))]
internal sealed partial class MachineMemoryJson : JsonSerializerContext;
