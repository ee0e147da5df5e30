using System.Collections.Frozen;

namespace Engraver.Simulator.Values;

/// <summary>Error codes of TC and their texts (galil-dmc.md A.8).</summary>
internal static class Tc
{
    public const int Unrecognized = 1;
    public const int OnlyFromProgram = 2;
    public const int NotInProgram = 3;
    public const int OperandError = 4;
    public const int InputBufferFull = 5;
    public const int OutOfRange = 6;
    public const int NotWhileRunning = 7;
    public const int NotWhileStopped = 8;
    public const int VariableError = 9;
    public const int UndefinedLabel = 10;
    public const int InvalidLine = 11;
    public const int TooDeep = 12;
    public const int NotJogging = 13;
    public const int WrongSignOfIncrement = 16;
    public const int ProgramRunning = 17;
    public const int NotWhileContouring = 18;
    public const int ThreadBusy = 19;
    public const int MotorOff = 20;
    public const int BeginWhileRunning = 21;
    public const int BeginAtLimit = 22;
    public const int NoSequence = 24;
    public const int PlaneNotValid = 28;
    public const int CoordinatedMove = 29;
    public const int SegmentTooShort = 30;
    public const int SequenceTooLong = 31;
    public const int SegmentBufferFull = 32;
    public const int SegmentsMixed = 33;
    public const int NoTimeSpecified = 39;
    public const int ContourRange = 41;
    public const int ContourTooSlow = 42;
    public const int MasterAndFollower = 46;
    public const int NotEnoughFields = 50;
    public const int BadString = 52;
    public const int BadBraces = 53;
    public const int MissingBracket = 55;
    public const int BadIndex = 56;
    public const int BadFunction = 57;
    public const int BadOperand = 58;
    public const int Parentheses = 59;
    public const int DownloadError = 60;
    public const int BadLabel = 61;
    public const int TooManyLabels = 62;
    public const int MissingEndif = 63;
    public const int ArraySpaceFull = 66;
    public const int TooManyNames = 67;
    public const int AlreadyRecording = 80;
    public const int NothingToRecord = 81;
    public const int UndefinedArray = 82;
    public const int NotANumber = 83;
    public const int TooManyElements = 84;
    public const int BadAxis = 90;
    public const int NotWithCamRunning = 100;
    public const int CamIndex = 101;
    public const int NoCamMaster = 102;
    public const int CamModulusTooLarge = 103;
    public const int NotOnCamSlave = 104;
    public const int CamNotEnabled = 105;
    public const int LostSync = 123;
    public const int AnalogAbsent = 132;
    public const int MustBeUdp = 133;

    private static readonly FrozenDictionary<int, string> Texts = new Dictionary<int, string>
    {
        [1] = "Unrecognized command",
        [2] = "Command only valid from program",
        [3] = "Command not valid in program",
        [4] = "Operand error",
        [5] = "Input buffer full",
        [6] = "Number out of range",
        [7] = "Command not valid while running",
        [8] = "Command not valid when not running",
        [9] = "Variable error",
        [10] = "Empty program line or undefined label",
        [11] = "Invalid label or line number",
        [12] = "Subroutine more than 16 deep",
        [13] = "JG only valid when running in jog mode",
        [16] = "IP incorrect sign during position move or IP given during forced deceleration",
        [17] = "ED, BN and DL not valid while program running",
        [18] = "Command not valid when contouring",
        [19] = "Application strand already executing",
        [20] = "Begin not valid with motor off",
        [21] = "Begin not valid while running",
        [22] = "Begin not possible due to limit switch",
        [24] = "Begin not valid because no sequence defined",
        [28] = "S operand not valid",
        [29] = "Not valid during coordinated move",
        [30] = "Sequence segment too short",
        [31] = "Total move distance in a sequence > 2 billion",
        [32] = "More than 511 segments in a sequence",
        [33] = "VP or CR commands cannot be mixed with LI commands",
        [39] = "No time specified",
        [41] = "Contouring record range error",
        [42] = "Contour data being sent too slowly",
        [46] = "Gear axis both master and follower",
        [50] = "Not enough fields",
        [51] = "Question mark not valid",
        [52] = "Missing \" or string too long",
        [53] = "Error in {}",
        [55] = "Missing [ or []",
        [56] = "Array index invalid or out of range",
        [57] = "Bad function or array",
        [58] = "Bad command response (i.e. _GNX)",
        [59] = "Mismatched parentheses",
        [60] = "Download error - line too long or too many lines",
        [61] = "Duplicate or bad label",
        [62] = "Too many labels",
        [63] = "IF statement without ENDIF",
        [66] = "Array space full",
        [67] = "Too many arrays or variables",
        [80] = "Record mode already running",
        [81] = "No array or source specified",
        [82] = "Undefined array",
        [83] = "Not a valid number",
        [84] = "Too many elements",
        [90] = "Only A B C D valid operand",
        [96] = "SM jumper needs to be installed for stepper motor operation",
        [100] = "Not valid when running ECAM",
        [101] = "Improper index into ET (0-256)",
        [102] = "No master axis defined for ECAM",
        [103] = "Master axis modulus greater than 256*EP value",
        [104] = "Not valid when axis performing ECAM",
        [105] = "EB1 command must be given first",
        [123] = "TCP lost sync",
        [132] = "Analog inputs not present",
        [133] = "Handle must be UDP",
    }.ToFrozenDictionary();

    public static string TextOf(int code) => code == 0 ? "No error" : Texts.GetValueOrDefault(code, "Undefined error");
}
