using System.Collections.Frozen;
using System.Globalization;

namespace Engraver.Galil.Protocol;

/// <summary>The texts of TC1 and the meaning of those that an operator may see (galil-dmc.md A.8).</summary>
public static class TcCodes
{
    private static readonly FrozenDictionary<TcCode, string> Texts = new Dictionary<TcCode, string>
    {
        [TcCode.UnrecognizedCommand] = "Unrecognized command",
        [TcCode.OnlyValidFromProgram] = "Command only valid from program",
        [TcCode.NotValidInProgram] = "Command not valid in program",
        [TcCode.OperandError] = "Operand error",
        [TcCode.InputBufferFull] = "Input buffer full",
        [TcCode.NumberOutOfRange] = "Number out of range",
        [TcCode.NotValidWhileRunning] = "Command not valid while running",
        [TcCode.NotValidWhenNotRunning] = "Command not valid when not running",
        [TcCode.VariableError] = "Variable error",
        [TcCode.UndefinedLabel] = "Empty program line or undefined label",
        [TcCode.InvalidLabelOrLineNumber] = "Invalid label or line number",
        [TcCode.SubroutineTooDeep] = "Subroutine more than 16 deep",
        [TcCode.JgOnlyWhenJogging] = "JG only valid when running in jog mode",
        [TcCode.EEPROMCheckSumError] = "EEPROM check sum error",
        [TcCode.EEPROMWriteError] = "EEPROM write error",
        [TcCode.IpIncorrectSign] = "IP incorrect sign during position move or IP given during forced deceleration",
        [TcCode.DownloadWhileProgramRunning] = "ED, BN and DL not valid while program running",
        [TcCode.NotValidWhenContouring] = "Command not valid when contouring",
        [TcCode.ThreadAlreadyExecuting] = "Application strand already executing",
        [TcCode.BeginNotValidWithMotorOff] = "Begin not valid with motor off",
        [TcCode.BeginWhileRunning] = "Begin not valid while running",
        [TcCode.BeginAgainstLimitSwitch] = "Begin not possible due to limit switch",
        [TcCode.BeginWithoutSequence] = "Begin not valid because no sequence defined",
        [TcCode.VariableNotGivenForIn] = "Variable not given in IN command",
        [TcCode.SOperandNotValid] = "S operand not valid",
        [TcCode.NotValidDuringCoordinatedMove] = "Not valid during coordinated move",
        [TcCode.SequenceSegmentTooShort] = "Sequence segment too short",
        [TcCode.SequenceTooLong] = "Total move distance in a sequence > 2 billion",
        [TcCode.SegmentBufferFull] = "More than 511 segments in a sequence",
        [TcCode.VectorMixedWithLinear] = "VP or CR commands cannot be mixed with LI commands",
        [TcCode.NoTimeSpecified] = "No time specified",
        [TcCode.ContouringRecordRangeError] = "Contouring record range error",
        [TcCode.ContourDataTooSlow] = "Contour data being sent too slowly",
        [TcCode.GearAxisBothMasterAndFollower] = "Gear axis both master and follower",
        [TcCode.NotEnoughFields] = "Not enough fields",
        [TcCode.QuestionMarkNotValid] = "Question mark not valid",
        [TcCode.StringTooLong] = "Missing \" or string too long",
        [TcCode.ErrorInBraces] = "Error in {}",
        [TcCode.QuestionMarkPartOfString] = "Question mark part of string",
        [TcCode.MissingBracket] = "Missing [ or []",
        [TcCode.ArrayIndexInvalidOrOutOfRange] = "Array index invalid or out of range",
        [TcCode.BadFunctionOrArray] = "Bad function or array",
        [TcCode.BadCommandResponse] = "Bad command response (i.e. _GNX)",
        [TcCode.MismatchedParentheses] = "Mismatched parentheses",
        [TcCode.DownloadError] = "Download error - line too long or too many lines",
        [TcCode.DuplicateOrBadLabel] = "Duplicate or bad label",
        [TcCode.TooManyLabels] = "Too many labels",
        [TcCode.IFStatementWithoutENDIF] = "IF statement without ENDIF",
        [TcCode.InNeedsComma] = "IN command must have a comma",
        [TcCode.ArraySpaceFull] = "Array space full",
        [TcCode.TooManyArraysOrVariables] = "Too many arrays or variables",
        [TcCode.NotValidFromUSBPort] = "Not valid from USB port",
        [TcCode.InOnlyInThread0] = "IN only valid in task #0",
        [TcCode.RecordModeAlreadyRunning] = "Record mode already running",
        [TcCode.NoArrayOrSourceSpecified] = "No array or source specified",
        [TcCode.UndefinedArray] = "Undefined array",
        [TcCode.NotAValidNumber] = "Not a valid number",
        [TcCode.TooManyElements] = "Too many elements",
        [TcCode.OnlyABCDValid] = "Only A B C D valid operand",
        [TcCode.StepperJumperMissing] = "SM jumper needs to be installed for stepper motor operation",
        [TcCode.BadBinaryCommandFormat] = "Bad binary command format",
        [TcCode.BinaryNotValidInProgram] = "Binary commands not valid in application program",
        [TcCode.BadBinaryCommandNumber] = "Bad binary command number",
        [TcCode.NotValidWhenRunningECAM] = "Not valid when running ECAM",
        [TcCode.ImproperEcamIndex] = "Improper index into ET (0-256)",
        [TcCode.NoMasterAxisDefinedForECAM] = "No master axis defined for ECAM",
        [TcCode.MasterModulusTooLarge] = "Master axis modulus greater than 256*EP value",
        [TcCode.NotValidWhenAxisPerformingECAM] = "Not valid when axis performing ECAM",
        [TcCode.EB1CommandMustBeGivenFirst] = "EB1 command must be given first",
        [TcCode.NoHallEffectSensorsDetected] = "No hall effect sensors detected",
        [TcCode.MustBeBrushless] = "Must be made brushless by BA command",
        [TcCode.BZCommandTimeout] = "BZ command timeout",
        [TcCode.NoMovementInBZCommand] = "No movement in BZ command",
        [TcCode.BZCommandRunaway] = "BZ command runaway",
        [TcCode.WrongGl1600] = "Controller has GL1600 not GL1800",
        [TcCode.BadEthernetTransmit] = "Bad Ethernet transmit",
        [TcCode.BadEthernetPacketReceived] = "Bad Ethernet packet received",
        [TcCode.EthernetInputBufferOverrun] = "Ethernet input buffer overrun",
        [TcCode.TCPLostSync] = "TCP lost sync",
        [TcCode.EthernetHandleAlreadyInUse] = "Ethernet handle already in use",
        [TcCode.NoARPResponseFromIPAddress] = "No ARP response from IP address",
        [TcCode.ClosedEthernetHandle] = "Closed Ethernet handle",
        [TcCode.IllegalModbusFunctionCode] = "Illegal Modbus function code",
        [TcCode.IpAddressNotValid] = "IP address not valid",
        [TcCode.IllegalIocCommand] = "Illegal IOC command",
        [TcCode.TimeoutOnSerialPort] = "Timeout on serial port",
        [TcCode.AnalogInputsNotPresent] = "Analog inputs not present",
        [TcCode.HandleMustBeUDP] = "Handle must be UDP",
    }.ToFrozenDictionary();

    private static readonly FrozenDictionary<TcCode, string> Meanings = new Dictionary<TcCode, string>
    {
        [TcCode.UnrecognizedCommand] = "TcCodes.UnrecognizedCommand",
        [TcCode.InputBufferFull] = "TcCodes.InputBufferFull",
        [TcCode.NumberOutOfRange] = "TcCodes.NumberOutOfRange",
        [TcCode.NotValidWhileRunning] = "TcCodes.NotValidWhileRunning",
        [TcCode.DownloadWhileProgramRunning] = "TcCodes.DownloadWhileProgramRunning",
        [TcCode.ThreadAlreadyExecuting] = "TcCodes.ThreadAlreadyExecuting",
        [TcCode.BeginNotValidWithMotorOff] = "TcCodes.BeginNotValidWithMotorOff",
        [TcCode.BeginWhileRunning] = "TcCodes.BeginWhileRunning",
        [TcCode.BeginAgainstLimitSwitch] = "TcCodes.BeginAgainstLimitSwitch",
        [TcCode.BeginWithoutSequence] = "TcCodes.BeginWithoutSequence",
        [TcCode.NotValidDuringCoordinatedMove] = "TcCodes.NotValidDuringCoordinatedMove",
        [TcCode.SequenceSegmentTooShort] = "TcCodes.SequenceSegmentTooShort",
        [TcCode.SequenceTooLong] = "TcCodes.SequenceTooLong",
        [TcCode.SegmentBufferFull] = "TcCodes.SegmentBufferFull",
        [TcCode.VectorMixedWithLinear] = "TcCodes.VectorMixedWithLinear",
        [TcCode.ArrayIndexInvalidOrOutOfRange] = "TcCodes.ArrayIndexInvalidOrOutOfRange",
        [TcCode.DownloadError] = "TcCodes.DownloadError",
        [TcCode.ArraySpaceFull] = "TcCodes.ArraySpaceFull",
        [TcCode.TooManyArraysOrVariables] = "TcCodes.TooManyArraysOrVariables",
    }.ToFrozenDictionary();

    /// <summary>The controller's text for a code; for a code that is not in the table, the number in words.</summary>
    public static string Text(TcCode code) => Texts.TryGetValue(code, out var text) ? text : Wording.Get("TcCodes.Error", (int)code);

    /// <summary>The meaning of the code, as the second half of a sentence after a colon; empty if the text is sufficient.</summary>
    public static string Hint(TcCode code) => Meanings.TryGetValue(code, out var meaning) ? ": " + Wording.Get(meaning) : "";

    /// <summary>Parses the reply of TC1: number and text, separated by any white space.</summary>
    /// <returns>False when the reply does not start with a number.</returns>
    public static bool TryParse(string answer, out TcCode code, out string text)
    {
        ArgumentNullException.ThrowIfNull(answer);
        var trimmed = answer.AsSpan().Trim();
        var end = trimmed.IndexOfAny(' ', '\t');
        var digits = end < 0 ? trimmed : trimmed[..end];
        var known = int.TryParse(digits, NumberStyles.None, CultureInfo.InvariantCulture, out var number);
        code = known ? (TcCode)number : TcCode.None;
        text = end < 0 ? Text(code) : trimmed[end..].Trim().ToString();
        return known;
    }
}
