using System.Buffers.Binary;
using System.Text;
using Engraver.Simulator.Motion;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language.Commands;

/// <summary>The QR data record of a 21x3 (galil-dmc.md A.9): header 4, general 24, planes 2 x 8, axes 4 x 28 bytes, little endian.</summary>
internal sealed class DataRecord
{
    private const string Blocks = "STIABCD";
    private readonly byte[] _bytes = new byte[156];
    private readonly Machine _machine;
    private int _length = 4;

    private DataRecord(Machine machine) => _machine = machine;

    /// <summary>The record as Latin-1 characters, without the prompt.</summary>
    /// <param name="mask">Letters of the requested blocks; empty for all blocks.</param>
    public static string Build(Machine _machine, string mask)
    {
        var wanted = mask.Trim().Length == 0 ? Blocks : mask.Trim();
        if (wanted.Any(c => !Blocks.Contains(c, StringComparison.Ordinal)))
            throw new CommandRefusedException(Tc.OperandError);

        var record = new DataRecord(_machine);
        record.Fill(wanted);
        return Encoding.Latin1.GetString(record._bytes, 0, record._length);
    }

    private void Fill(string wanted)
    {
        _bytes[0] = 0x80;
        if (Includes(wanted, 'I'))
        {
            _bytes[0] |= 4;
            AddGeneral();
        }

        for (var i = 0; i < 2; i++)
        {
            if (Includes(wanted, (char)('S' + i)))
            {
                _bytes[0] |= (byte)(1 << i);
                AddPlane(_machine.Motion.Planes[i]);
            }
        }

        for (var i = 0; i < Axis.Real; i++)
        {
            if (Includes(wanted, (char)('A' + i)))
            {
                _bytes[1] |= (byte)(1 << i);
                AddAxis(_machine.Motion.Axes[i]);
            }
        }

        BinaryPrimitives.WriteUInt16LittleEndian(_bytes.AsSpan(2), (ushort)_length);
    }

    private static bool Includes(string wanted, char block) => wanted.Contains(block, StringComparison.Ordinal);

    private Span<byte> Next(int size)
    {
        var span = _bytes.AsSpan(_length, size);
        _length += size;
        return span;
    }

    private void AddGeneral()
    {
        var block = Next(24);
        BinaryPrimitives.WriteUInt16LittleEndian(block, (ushort)_machine.Time);
        block[2] = _machine.Io.Inputs;
        block[12] = _machine.Io.Outputs;
        block[22] = (byte)_machine.LastError;
        block[23] = (byte)((_machine.Threads.AnyRunning ? 0x80 : 0) | (_machine.Threads.IsTracing ? 0x02 : 0) | (_machine.Serial.Echo ? 0x01 : 0));
    }

    private void AddPlane(VectorPlane plane)
    {
        var block = Next(8);
        BinaryPrimitives.WriteUInt16LittleEndian(block, (ushort)plane.Profile.SegmentIndex);
        var status = (plane.IsActive ? 1 << 15 : 0)
            | (plane is { IsActive: true, Profile: { IsStopping: false, Speed: > 0 } } && plane.IsAtSpeed ? 1 << 5 : 0)
            | (plane.Profile.IsStopping ? 1 << 4 : 0)
            | (plane.Profile.IsEnding ? 1 << 3 : 0);
        BinaryPrimitives.WriteUInt16LittleEndian(block[2..], (ushort)status);
        BinaryPrimitives.WriteInt32LittleEndian(block[4..], (int)Math.Floor(plane.Profile.Travelled + 1e-6));
    }

    private void AddAxis(Axis axis)
    {
        var block = Next(28);
        BinaryPrimitives.WriteUInt16LittleEndian(block, (ushort)Status(_machine, axis));
        block[2] = (byte)((axis.Latch.IsArmed ? 0 : 0x40) | (axis.Inputs.ForwardHit ? 0 : 8) | (axis.Inputs.ReverseHit ? 0 : 4) | (axis.Inputs.Home ? 2 : 0) | (axis.IsStepper ? 1 : 0));
        block[3] = (byte)axis.StopCode;
        BinaryPrimitives.WriteInt32LittleEndian(block[4..], axis.Reference);
        BinaryPrimitives.WriteInt32LittleEndian(block[8..], axis.Encoder);
        BinaryPrimitives.WriteInt32LittleEndian(block[12..], axis.Error);
        BinaryPrimitives.WriteInt32LittleEndian(block[16..], axis.SecondEncoder);
        BinaryPrimitives.WriteInt32LittleEndian(block[20..], (int)Math.Round(_machine.Motion.VelocityOf(axis) * 64));
    }

    /// <summary>The status word of an axis (A.9).</summary>
    public static int Status(Machine machine, Axis axis)
    {
        var motion = machine.Motion;
        var coordinated = motion.IsCoordinated(axis);
        return (axis.IsMoving || coordinated || (motion.Contour.CanProgress && motion.Contour.Drives(axis)) ? 1 << 15 : 0)
            | (axis is { IsMoving: true, CurrentMove: not AxisMove.Jog } ? 1 << 14 : 0)
            | (axis is { IsMoving: true, CurrentMove: AxisMove.Absolute } ? 1 << 13 : 0)
            | (axis.Homing is not null && axis.CurrentMove == AxisMove.FindEdge ? 1 << 12 : 0)
            | (axis.Homing is not null && axis.CurrentMove == AxisMove.Home ? 1 << 11 : 0)
            | (axis.Homing?.Phase >= HomingPhase.Approach ? 1 << 10 : 0)
            | (axis.Homing?.Phase >= HomingPhase.Index ? 1 << 9 : 0)
            | (coordinated ? 1 << 8 : 0)
            | (motion.VelocityOf(axis) < 0 ? 1 << 7 : 0)
            | (motion.Contour.Drives(axis) ? 1 << 6 : 0)
            | (axis.IsAtSpeed ? 1 << 5 : 0)
            | (axis.IsStopping ? 1 << 4 : 0)
            | (axis.IsEnding ? 1 << 3 : 0)
            | (axis.Latch.IsArmed ? 1 << 2 : 0)
            | (axis.OffOnError is 1 or 3 ? 1 << 1 : 0)
            | (axis.MotorOff ? 1 : 0);
    }
}
