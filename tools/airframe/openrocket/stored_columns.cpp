// SPDX-License-Identifier: MIT
#include "airframe/openrocket/stored_columns.hpp"

namespace fantail::airframe::openrocket {
namespace {

constexpr std::array<std::string_view, 12> mass_names{"mass",  "Mass", "الكتلة", "Hmotnost", "Masse", "Masa",
                                                      "Massa", "質量", "Massa.", "Масса",    "Маса",  "质量"};
constexpr std::array<std::string_view, 14> gravity_names{
    "cg_location",       "CG location",       "موقع مركز الجاذبية", "Umístení težište", "Position vom CG",
    "Situación del CG",  "Emplacement du CG", "posizione CG",       "CG位置",           "ZP locatie",
    "Localização do CG", "Положение ЦТ",      "Позиція ЦГ",         "CG 重心位置"};
constexpr std::array<std::string_view, 14> pressure_names{
    "cp_location",     "CP location",      "موقع مركز الضغط",   "Umístení pusobište tlaku",
    "Position vom CP", "Situación del CP", "Emplacement du CP", "posizione CP",
    "CP位置",          "DP locatie",       "Localização do CP", "Положение ЦД",
    "Позиція ЦП",      "CP 压心位置"};
constexpr std::array<std::string_view, 13> margin_names{"stability",
                                                        "Stability margin calibers",
                                                        "عيارات هامش الإستقرار",
                                                        "Kvalita bezpecnosti stability",
                                                        "Stabilität in Kalibern",
                                                        "Margen de estabilidad en Calibres",
                                                        "Calibres marge de stabilité",
                                                        "Calibri del margine di stabilita'",
                                                        "Stabiliteitsmarge kalibers",
                                                        "Calibres da margem de estabilidade",
                                                        "Запас устойчивости в калибрах",
                                                        "Запас стабільності",
                                                        "稳定裕量"};
constexpr std::array<std::string_view, 13> angle_names{"aoa",
                                                       "Angle of attack",
                                                       "Úhel nábehu",
                                                       "Angriffswinkel",
                                                       "Ángulo de ataque",
                                                       "Angle d'attaque",
                                                       "Angolo d'attacco",
                                                       "迎え角",
                                                       "Invalshoek",
                                                       "Ângulo de ataque",
                                                       "Угол атаки",
                                                       "Кут атаки",
                                                       "攻角"};
constexpr std::array<std::string_view, 12> mach_names{
    "mach_number",    "Mach number", "رقمم ماخ",   "Machovo císlo",  "Machzahl",   "Número Mach",
    "Numero di Mach", "マッハ数",    "Mach-getal", "Número de Mach", "Число Маха", "马赫数"};
constexpr std::array<std::string_view, 14> climb_names{"velocity_z",
                                                       "Vertical velocity",
                                                       "السرعة العمودية",
                                                       "Svislá rychlost",
                                                       "Vertikalgeschwindigkeit",
                                                       "Velocidad vertical",
                                                       "Vitesse verticale",
                                                       "Velocita' verticale",
                                                       "垂直方向速度",
                                                       "Verticale snelheid",
                                                       "Velocidade vertical",
                                                       "Вертикальная скорость",
                                                       "Вертикальна швидкість",
                                                       "垂直速度"};

}  // namespace

const std::array<std::span<const std::string_view>, quantities>& stored_columns() {
  static const std::array<std::span<const std::string_view>, quantities> all{
      mass_names, gravity_names, pressure_names, margin_names, angle_names, mach_names, climb_names};
  return all;
}

}  // namespace fantail::airframe::openrocket
